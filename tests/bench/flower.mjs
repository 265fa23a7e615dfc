/** Flowers from text to triangles, compared with the times of Petrenko (2014, figure 28) for four of them. */
import { grower } from "./core.mjs";
import { microseconds, printTable } from "./statistics.mjs";

const RUNS = 9;
/** Seconds in 2012. */
const FIGURE_28 = { tulip: 37.5, "water-lily": 120.4, bluebell: 56.3, poppy: 63.4 };
/** A parameter of a text that only moves its volumes, and a value for it. */
const placesOf = (name) => PLACES[name] ?? ["length", 123];
const PLACES = { meadow: ["height", 1.1], "water-lily": ["scale", 1.1] };
/** Target times for one flower and for hundreds, milliseconds. */
const aimOf = (name) => (name === "meadow" ? 300 : FIGURE_28[name] ? 50 : "–");

const milliseconds = (micro) => (micro / 1000).toFixed(1);

export async function benchFlowers({ core, instance, source }) {
	const { FLOWERS, flowerOf, stemsAlone } = await source("tests/bench/flower_requests.ts");
	const rows = [
		["", "volumes", "darts", "triangles", "map ms", "with skin ms", "placed anew ms", "aim ms", "thesis s"],
	];
	for (const name of FLOWERS) {
		const { columns } = instance.growBytes(flowerOf(name, true));
		const counts = columns.uint32("counts");
		const names = columns.text("counts.names").split("\n");
		const of = (what) => counts[names.indexOf(what)];
		// The core keeps its last flower: after a stem of one volume it grows it anew, of another size it places the same.
		const grown = [false, true].map((meshes) =>
			afterEach(inTurn(stemsAlone.map((stem) => grower(core, stem))), grower(core, flowerOf(name, meshes))),
		);
		const placed = inTurn([{}, { number: placesOf(name) }].map((of) => grower(core, flowerOf(name, true, 1, of))));
		const times = [...grown, placed].map((run) => microseconds(2, RUNS, run));
		rows.push([
			name,
			of("volumes"),
			of("darts"),
			of("triangles"),
			...times.map(milliseconds),
			aimOf(name),
			FIGURE_28[name] ?? "–",
		]);
	}
	printTable("Flowers as wasm, text and all, rounded once", rows);
}

/** One before each round of the other. */
function afterEach(before, run) {
	return (rounds) => {
		for (let i = 0; i < rounds; i++) {
			before(1);
			run(1);
		}
	};
}

/** Runs one after the other. */
function inTurn(runs) {
	let turn = 0;
	return (rounds) => {
		for (let i = 0; i < rounds; i++) runs[turn++ % runs.length](1);
	};
}
