/**
 * Trees by divisor functions: what each stage of one costs, thousands of different ones with all their levels (the sizes of
 * Kim, Kim and Cho 2013, Table 2), and whole trees beside those of ez-tree.
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
		triangles: columns.words(`mesh.level${level}.indices`).length / 3,
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
 * Like for like: one mesh of bark and leaves, of a tree of as many branches and as many vertices, or more. Steps give ours its branches;
 * leaves make up for the vertices, with positions, normals and indices as there, and a byte of sky in place of texture coordinates.
 */
async function benchPeer(core, instance, request) {
	const ours = ["ours: steps", "branches", "vertices", "ms", "times as fast", "with all levels"];
	const rows = [["ez-tree", "branches", "vertices", "ms", ...ours]];
	const ratios = { one: [], all: [] };
	for (const peer of await peerTrees()) {
		const own = match(instance, request, peer);
		// By turns, so that whatever else the machine does comes to all of them.
		const times = { peer: [], one: [], all: [] };
		for (let run = 0; run < RUNS; run++) {
			times.peer.push(peer.time(1));
			times.one.push(microseconds(20, 1, grower(core, request(1, own.steps, own.leaves, 1))));
			times.all.push(microseconds(20, 1, grower(core, request(1, own.steps, own.leaves, 4))));
		}
		const [theirs, one, all] = [times.peer, times.one, times.all].map(median);
		ratios.one.push(theirs / one);
		ratios.all.push(theirs / all);
		const faster = [theirs / one, theirs / all].map((ratio) => ratio.toFixed(1));
		const mine = [own.steps, own.branches, own.vertices, milliseconds(one)];
		rows.push([peer.name, peer.branches, peer.vertices, milliseconds(theirs), ...mine, ...faster]);
	}
	printTable("Whole trees from parameters to the buffers of one mesh, in Node: ez-tree's presets and ours", rows);
	const [one, all] = [ratios.one, ratios.all].map((each) => geometricMean(each).toFixed(1));
	console.log(`geometric mean: ${one} times as fast (aim: 10); with all four levels ${all}`);
}

/** The fewest steps that make as many branches, and the fewest leaves that then make as many vertices. */
function match(instance, request, { branches, vertices }) {
	const grown = (steps, leaves) => {
		const { columns } = instance.growBytes(request(1, steps, leaves, 1));
		const counts = columns.lines("counts.names");
		return {
			steps,
			leaves,
			branches: columns.words("counts")[counts.indexOf("branches")],
			vertices: columns.floats("mesh.level0.positions").length / 3,
		};
	};
	let own = grown(1, 1);
	while (own.branches < branches) own = grown(own.steps + 1, 1);
	while (own.vertices < vertices) own = grown(own.steps, own.leaves + 1);
	return own;
}
