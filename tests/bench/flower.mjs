/** Flowers from their text to triangles, beside what Petrenko (2014, figure 28) took for four of them. */
import { grower } from "./core.mjs";
import { microseconds, printTable } from "./statistics.mjs";

const RUNS = 9;
/** Seconds in 2012. */
const FIGURE_28 = { tulip: 37.5, "water-lily": 120.4, bluebell: 56.3, poppy: 63.4 };

const milliseconds = (micro) => (micro / 1000).toFixed(1);

export async function benchFlowers({ core, instance, source }) {
	const { FLOWERS, flowerOf } = await source("tests/bench/flower_requests.ts");
	const rows = [["", "volumes", "darts", "triangles", "map ms", "with skin ms", "aim ms", "thesis s"]];
	for (const name of FLOWERS) {
		const { columns } = instance.growBytes(flowerOf(name, true));
		const counts = columns.words("counts");
		const names = columns.text("counts.names").split(" ");
		const of = (what) => counts[names.indexOf(what)];
		const times = [false, true].map((meshes) => microseconds(1, RUNS, grower(core, flowerOf(name, meshes))));
		rows.push([
			name,
			of("volumes"),
			of("darts"),
			of("triangles"),
			...times.map(milliseconds),
			FIGURE_28[name] ? 50 : "–",
			FIGURE_28[name] ?? "–",
		]);
	}
	printTable("Flowers as wasm, text and all, rounded once", rows);
}
