/**
 * Trees by divisor functions: the time of each stage of one tree, of thousands of different trees with all levels (the
 * sizes of Kim, Kim and Cho 2013, Table 2), and of whole trees compared with ez-tree.
 */
import { grower, KERNELS } from "./core.mjs";
import { peerTrees } from "./peer_trees.mjs";
import { geometricMean, median, microseconds, printTable } from "./statistics.mjs";

const STAGES = ["text", "population", "form", "moment", "leaves", "levels"];
/** Number of trees, their steps, and the nodes a tree that the paper counts. */
const TABLE_2 = [
	[500, [7, 8, 9], 194],
	[1000, [7], 155],
	[1500, [6], 99],
	[2000, [5], 59],
];
const MIXED = [5, 6, 7];
const RUNS = 5;

const milliseconds = (micro) => (micro / 1000).toFixed(3);

export async function benchGrowth({ core, instance, source }) {
	const { levelsOf: request, leafyOf } = await source("tests/bench/growth_requests.ts");
	const vertices = (bytes) => sizesOf(instance.growBytes(bytes).columns);
	benchStages(core);
	benchMany(core, request, vertices);
	await benchPeer(core, instance, leafyOf);
}

/** Vertices and triangles of each level. */
function sizesOf(columns) {
	return [0, 1, 2, 3].map((level) => ({
		vertices: columns.floats(`mesh.level${level}.positions`).length / 3,
		triangles: columns.uint32(`mesh.level${level}.indices`).length / 3,
	}));
}

function benchStages(core) {
	const rows = [["steps", "branches", ...STAGES.map((stage) => `${stage} µs`), "all µs"]];
	const rounds = 200;
	for (const steps of [5, 6, 7, 8, 9]) {
		const until = STAGES.map((stage) =>
			microseconds(rounds, RUNS, (times) => core.panicle_bench(KERNELS[`growth_${stage}`], steps, times)),
		);
		const branches = core.panicle_bench(KERNELS.growth_population, steps, 1);
		const each = until.map((time, i) => (time - (until[i - 1] ?? 0)).toFixed(1));
		rows.push([steps, branches, ...each, until.at(-1).toFixed(0)]);
	}
	printTable(`A tree of σ1, stage by stage, as wasm: means of ${rounds} seeds`, rows);
}

/** Mean microseconds of a tree: every one of them another. */
function meanOf(core, requests) {
	const size = Math.max(...requests.map(({ length }) => length));
	const at = core.panicle_allocate(size);
	const time = microseconds(requests.length, 1, () => {
		for (const request of requests) {
			new Uint8Array(core.memory.buffer, at, request.length).set(request);
			core.panicle_release(core.panicle_grow(at, request.length));
		}
	});
	core.panicle_release(at);
	return time;
}

function benchMany(core, request, vertices) {
	const rows = [["trees", "steps", "nodes in the paper", "a tree, wasm ms", "triangles by level"]];
	const row = (count, steps, nodes) => {
		const requests = Array.from({ length: count }, (_, i) => request(i + 1, steps[i % steps.length]));
		const levels = vertices(requests[steps.length - 1]).map(({ triangles }) => triangles);
		rows.push([count, steps.join(", "), nodes, milliseconds(meanOf(core, requests)), levels.join(" / ")]);
	};
	for (const [count, steps, nodes] of TABLE_2) row(count, steps, nodes);
	row(2000, MIXED, "59–155");
	// The same size, more and more of them.
	for (const count of [500, 1000, 1500, 2000]) row(count, [6], 99);
	printTable("Table 2: different trees with four levels each (aim: 1 ms a tree of 59 to 194 nodes)", rows);
}

/**
 * Like for like: one mesh of bark and leaves, with positions, normals and indices as there, and a byte of sky in place of texture
 * coordinates. Steps give ours as many branches; then as many leaves, each as there one that is seen from all sides, or as many vertices: a
 * leaf of ours has four, folded, one of theirs mostly eight, crossed.
 */
async function benchPeer(core, instance, request) {
	const ways = ["leaves", "vertices"];
	const ours = ["ours: steps", "branches", ...ways.flatMap(() => ["leaves", "vertices", "ms", "times as fast"])];
	const rows = [["ez-tree", "branches", "leaves", "vertices", "ms", ...ours, "with all levels"]];
	const ratios = { leaves: [], vertices: [], levels: [] };
	for (const peer of await peerTrees()) {
		const own = ways.map((way) => match(instance, request, peer, way));
		const [alike, more] = own.map(({ steps, leaves }) => grower(core, request(1, steps, leaves, 1)));
		const levels = grower(core, request(1, own[1].steps, own[1].leaves, 4));
		// Alternating, so that other load on the machine affects all of them.
		const times = { peer: [], leaves: [], vertices: [], levels: [] };
		for (let run = 0; run < RUNS; run++) {
			times.peer.push(peer.time(1));
			times.leaves.push(microseconds(20, 1, alike));
			times.vertices.push(microseconds(20, 1, more));
			times.levels.push(microseconds(20, 1, levels));
		}
		const time = Object.fromEntries(Object.entries(times).map(([name, each]) => [name, median(each)]));
		for (const name of Object.keys(ratios)) ratios[name].push(time.peer / time[name]);
		const faster = (name) => ratios[name].at(-1).toFixed(1);
		const mine = ways.flatMap((way, i) => [own[i].counted, own[i].vertices, milliseconds(time[way]), faster(way)]);
		const theirs = [peer.name, peer.branches, peer.leaves, peer.vertices, milliseconds(time.peer)];
		rows.push([...theirs, own[0].steps, own[0].branches, ...mine, faster("levels")]);
	}
	printTable("Whole trees from parameters to the buffers of one mesh, in Node: ez-tree's presets and ours", rows);
	const [leaves, vertices, levels] = Object.values(ratios).map((each) => geometricMean(each).toFixed(1));
	console.log(
		`geometric means (aim: 10): ${leaves} times as fast with as many branches and leaves, ${vertices} with as many vertices too, ${levels} with all four levels of these`,
	);
}

/** The fewest steps that make as many branches, and the fewest leaves on each youngest internode that then make as many of `way`. */
function match(instance, request, peer, way) {
	const grown = (steps, leaves) => {
		const { columns } = instance.growBytes(request(1, steps, leaves, 1));
		const names = columns.lines("counts.names");
		const count = (name) => columns.uint32("counts")[names.indexOf(name)];
		const vertices = columns.floats("mesh.level0.positions").length / 3;
		return { steps, leaves, branches: count("branches"), counted: count("leaves"), vertices };
	};
	let own = grown(1, 1);
	while (own.branches < peer.branches) own = grown(own.steps + 1, 1);
	while ((way === "leaves" ? own.counted : own.vertices) < peer[way]) own = grown(own.steps, own.leaves + 1);
	return own;
}
