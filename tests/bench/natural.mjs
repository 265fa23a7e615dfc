/**
 * Time of the natural procedure from scratch: every preset, bunches of 120 and 500 berries, and the growth of time
 * with their number. A growth has three parts, each timed by omitting the others: the skeleton with its swollen
 * berries, the meshes of berries and stems, and the measures.
 */
import { grower, nativeGrow } from "./core.mjs";
import { microseconds, printTable } from "./statistics.mjs";

const RUNS = 7;
const ROUNDS = 2;
const COUNTS = [125, 250, 500, 1000, 1500, 2000, 3000];

const PARTS = {
	skeleton: { meshes: false, measures: false },
	meshes: { meshes: true, measures: false },
	measures: { meshes: false, measures: true },
	whole: { meshes: true, measures: true },
};

const milliseconds = (time) => (time / 1000).toFixed(2);

/** Prints the tables; returns the ratios wasm / native. */
export function benchNatural({ core, reader, encodeRequest, presets, specimenFromPreset }) {
	/** Microseconds of each part in wasm, of the skeleton and the whole natively, and how many berries there were. */
	const time = (specimen) => {
		const request = (part) => encodeRequest(specimen, PARTS[part]);
		const wasm = (part) => microseconds(ROUNDS, RUNS, grower(core, request(part)));
		const native = (part) => nativeGrow(request(part), ROUNDS, RUNS);
		const { berries } = reader.grow(request("skeleton")).counts;
		const [skeleton, whole] = [wasm("skeleton"), wasm("whole")];
		return {
			berries,
			skeleton,
			whole,
			meshes: wasm("meshes") - skeleton,
			measures: wasm("measures") - skeleton,
			nativeSkeleton: native("skeleton"),
			nativeWhole: native("whole"),
		};
	};
	// Wasm begins in its quick translation and is translated anew while it runs: that is over after this.
	grower(core, encodeRequest(bunchOf(specimenFromPreset, 120), PARTS.whole))(60);
	const timed = presets.map(({ name }) => [name, time(specimenFromPreset(name))]);
	const counted = COUNTS.map((count) => time(bunchOf(specimenFromPreset, count)));
	printParts(`Natural presets from nothing, wasm ms, medians of ${RUNS} runs of ${ROUNDS}`, timed);
	printParts("Natural bunches of 120 and 500 berries, wasm ms (aim: 120 in about 15 ms)", [
		["120 berries", time(bunchOf(specimenFromPreset, 120))],
		["500 berries", counted[COUNTS.indexOf(500)]],
	]);
	printGrowth(counted);
	return [...timed.map(([, one]) => one), ...counted].flatMap((one) => [
		one.skeleton / one.nativeSkeleton,
		one.whole / one.nativeWhole,
	]);
}

/** That many berries in the outline of the long conical bunch, of a size that fills it alike. */
function bunchOf(specimenFromPreset, count) {
	const specimen = specimenFromPreset("long-conical");
	const share = Math.cbrt(125 / count);
	const { size, pedicel } = specimen.parameters;
	Object.assign(specimen.parameters, { count, size: size * share, pedicel: pedicel * share });
	return specimen;
}

function printParts(title, timed) {
	const heads = ["", "berries", "skeleton", "ratio", "+ meshes", "+ measures", "whole", "native whole", "ratio"];
	const rows = timed.map(([name, one]) => [
		name,
		one.berries,
		milliseconds(one.skeleton),
		(one.skeleton / one.nativeSkeleton).toFixed(2),
		milliseconds(one.meshes),
		milliseconds(one.measures),
		milliseconds(one.whole),
		milliseconds(one.nativeWhole),
		(one.whole / one.nativeWhole).toFixed(2),
	]);
	printTable(title, [heads, ...rows]);
}

/** Beside each time, how it grew from the row before, over how n log n did: 1 or less is as promised. */
function printGrowth(counted) {
	const heads = ["berries", "skeleton ms", "µs a berry", "/ n log n", "whole ms", "µs a berry", "/ n log n"];
	const work = ({ berries }) => berries * Math.log(berries);
	const growth = (i, part) => {
		if (i === 0) return "";
		const [before, now] = [counted[i - 1], counted[i]];
		return (now[part] / before[part] / (work(now) / work(before))).toFixed(2);
	};
	const rows = counted.map((one, i) => [
		one.berries,
		...["skeleton", "whole"].flatMap((part) => [
			milliseconds(one[part]),
			(one[part] / one.berries).toFixed(1),
			growth(i, part),
		]),
	]);
	printTable("Natural bunches as berries get more and smaller, wasm", [heads, ...rows]);
}
