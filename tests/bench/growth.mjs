/**
 * Trees by divisor functions: what each stage of one costs, thousands of different ones with all their levels (the sizes of
 * Kim, Kim and Cho 2013, Table 2), and whole trees beside those of ez-tree.
 */
import { grower, KERNELS } from "./core.mjs";
import { peerTrees } from "./peer_trees.mjs";
import { geometricMean, microseconds, printTable } from "./statistics.mjs";

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
	const { levelsOf: request } = await source("tests/bench/growth_requests.ts");
	const vertices = (bytes) => sizesOf(instance.growBytes(bytes).columns);
	benchStages(core);
	benchMany(core, request, vertices);
	await benchPeer(core, request, vertices);
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
	const time = microseconds(requests.length, 3, () => {
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
	// The same trees, more and more of them.
	for (const count of [500, 1000, 1500, 2000]) row(count, [6], 99);
	printTable("Table 2: different trees with four levels each (aim: 1 ms a tree of 59 to 194 nodes)", rows);
}

async function benchPeer(core, request, vertices) {
	const rows = [["ez-tree", "vertices", "ms", "ours: steps", "vertices", "ms", "times as fast", "a vertex"]];
	const ours = [5, 6, 7, 8, 9, 10].map((steps) => {
		const bytes = request(1, steps);
		const count = vertices(bytes).reduce((sum, level) => sum + level.vertices, 0);
		return { steps, count, time: microseconds(20, RUNS, grower(core, bytes)) };
	});
	const ratios = [];
	for (const { name, count, time } of await peerTrees(RUNS)) {
		// Ours of as many vertices, or more.
		const own = ours.find((tree) => tree.count >= count) ?? ours.at(-1);
		const ratio = time / own.time;
		const each = time / count / (own.time / own.count);
		ratios.push(ratio);
		rows.push([
			name,
			count,
			milliseconds(time),
			own.steps,
			own.count,
			milliseconds(own.time),
			ratio.toFixed(1),
			each.toFixed(1),
		]);
	}
	printTable("Whole trees from parameters to buffers, in Node: ez-tree's presets, and ours with all levels", rows);
	console.log(`geometric mean: ${geometricMean(ratios).toFixed(1)} times as fast (aim: 10)`);
}
