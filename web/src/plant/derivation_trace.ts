/** The trace of a derivation, step by step (columns: wasm-core/src/lsystem_plant/derivation_trace_columns.hpp). */
import type { Block, Columns } from "../core/container";

/** The most modules in a window. */
export const MAX_TRACE_ENTRIES = 2000;

/** The part of a derivation to trace. No link stores it. */
export interface TraceRequest {
	/** 0 is the axiom; steps beyond the last one give the last. */
	readonly step: number;
	/** Index of the window's first module in that step's string; 0 where absent. */
	readonly first?: number;
	/** Modules in the window, at most `MAX_TRACE_ENTRIES`, which is the default. */
	readonly count?: number;
	/** A module of the last string, for the trail of its ancestors (`DerivationTrace.trail`). */
	readonly module?: number;
}

/** The position of a production's predecessor in the text. */
export interface TextPlace {
	/** From 1. */
	readonly line: number;
	/** From 1, in characters. */
	readonly column: number;
}

/** Consecutive modules in a string. */
export interface ModuleSpan {
	/** Index of the first. */
	readonly first: number;
	/** May be 0: then `first` is the place where they would be. */
	readonly count: number;
}

/** The draw that chose a production among those that match. */
export interface Chance {
	/** The sum of the weights of all matching productions. */
	readonly total: number;
	/** The weight of the chosen production. */
	readonly weight: number;
	/** The drawn number, from 0 up to `total`. */
	readonly drawn: number;
}

/** The values that the environment set in a query module. */
export interface ModuleAnswer {
	/** Parameters before; undefined for ?P, ?H, ?L and ?U, which have no input. */
	readonly asked?: readonly string[];
	/** Parameters afterwards. */
	readonly answered: readonly string[];
	/** The environment's reasons, if any. */
	readonly words?: string;
}

/** A production that does not rewrite a module, with the reason. */
export interface Refusal {
	readonly production: TextPlace;
	/** "the condition is false with x = 3" */
	readonly why: string;
}

/** A module of the window. */
export interface TraceEntry {
	/** Its text in the string: `B(29)`. */
	readonly text: string;
	/** Index of its parent module in the step before; undefined in the axiom. */
	readonly parent?: number;
	/** The production that wrote it in this step; undefined where it was copied, and in the axiom. */
	readonly production?: TextPlace;
	/** The production that rewrites it next; undefined where it stays, is cut, or there is no next step. */
	readonly fires?: TextPlace;
	/** The other productions of its symbol, in the order of the text; absent where there are none. */
	readonly refusals?: readonly Refusal[];
	/**
	 * Values that the firing production uses, in its own order: parameters of predecessor and contexts, then results of
	 * its blocks.
	 */
	readonly values: readonly { readonly name: string; readonly value: string }[];
	/** For a firing production with a weight. */
	readonly chance?: Chance;
	/** Its successors in the next step; empty in the last step. */
	readonly children: ModuleSpan;
	/** Its descendants in the last string, whose indices `DerivationTrace.segments` and `organs` use. */
	readonly last: ModuleSpan;
	/** The environment's values before the next step. */
	readonly answer?: ModuleAnswer;
}

/** A derivation, and a window of one of its strings. */
export interface DerivationTrace {
	/** Modules in each step's string, from the axiom on. */
	readonly counts: Uint32Array;
	/** The traced step. */
	readonly step: number;
	/** Index of the first of `modules` in its string. */
	readonly first: number;
	/** The window's modules, in their order. */
	readonly modules: readonly TraceEntry[];
	/** For the requested module of the last string: the index of its ancestor in each step. */
	readonly trail?: Uint32Array;
	/** For each segment of the plant, the module of the last string that drew it; `NOT_DRAWN` where none did. */
	readonly segments: Uint32Array;
	/** The same for each organ. */
	readonly organs: Uint32Array;
}

/** Marks parts that the text did not draw: a peduncle, a second bunch. */
export const NOT_DRAWN = 0xffffffff;

/** Blocks of a request of a trace, besides the output word `chronicle`. */
export function traceBlocks({ step, first, count, module }: TraceRequest): Block[] {
	const word = (name: string, value: number | undefined): Block[] =>
		value === undefined ? [] : [{ name: `chronicle_${name}`, data: Uint32Array.of(value) }];
	return [...word("step", step), ...word("first", first), ...word("count", count), ...word("module", module)];
}

/** Returns the derivation trace in a response; undefined if not requested. */
export function readTrace(columns: Columns): DerivationTrace | undefined {
	if (!columns.has("chronicle.counts")) return undefined;
	const [step, first, count] = columns.uint32("chronicle.window");
	const pairs = (name: string, index: number) => columns.uint32(`chronicle.${name}`).subarray(2 * index, 2 * index + 2);
	const lines = (name: string) => columns.text(`chronicle.${name}`).split("\n");
	// Texts have one line per module of the window; numbers have one row.
	const [texts, values, answers, refused] = [lines("modules"), lines("values"), lines("answers"), lines("refusals")];
	const parents = columns.uint32("chronicle.parent");
	const chances = columns.floats("chronicle.chance");
	const modules = Array.from({ length: count }, (_, index): TraceEntry => {
		const [total, weight, drawn] = chances.subarray(3 * index, 3 * index + 3);
		const production = placeOf(pairs("production", index));
		const fires = placeOf(pairs("fires", index));
		const answer = answerOf(answers[index]);
		const refusals = refusalsOf(refused[index]);
		return {
			text: texts[index],
			...(parents[index] === NOT_DRAWN ? {} : { parent: parents[index] }),
			...(production ? { production } : {}),
			...(fires ? { fires } : {}),
			...(refusals.length > 0 ? { refusals } : {}),
			values: values[index].split(" ").filter(Boolean).map(assignment),
			...(total > 0 ? { chance: { total, weight, drawn } } : {}),
			children: spanOf(pairs("children", index)),
			last: spanOf(pairs("last", index)),
			...(answer ? { answer } : {}),
		};
	});
	return {
		counts: columns.uint32("chronicle.counts"),
		step,
		first,
		modules,
		...(columns.has("chronicle.trail") ? { trail: columns.uint32("chronicle.trail") } : {}),
		segments: columns.has("segments.module") ? columns.uint32("segments.module") : new Uint32Array(0),
		organs: columns.has("organs.module") ? columns.uint32("organs.module") : new Uint32Array(0),
	};
}

/** Reads a line and a column; undefined where there is none, which the core writes as line 0. */
function placeOf([line, column]: Uint32Array): TextPlace | undefined {
	return line === 0 ? undefined : { line, column };
}

/** Reads `3:1 the condition is false` for each production, separated by tabs. */
function refusalsOf(line: string): Refusal[] {
	return line
		.split("\t")
		.filter(Boolean)
		.map((text) => {
			const [place] = text.split(" ", 1);
			const [row, column] = place.split(":").map(Number);
			return { production: { line: row, column }, why: text.slice(place.length + 1) };
		});
}

/** Reads a range of modules: the first and their count. */
function spanOf([first, count]: Uint32Array): ModuleSpan {
	return { first, count };
}

/** Reads `name=value`. */
function assignment(pair: string): { name: string; value: string } {
	const equals = pair.indexOf("=");
	return { name: pair.slice(0, equals), value: pair.slice(equals + 1) };
}

/**
 * Reads the environment's response to a module; undefined for an empty line, which means no response. The line is
 * `asked 1 0 → 1 3; because; and because` after a query, or `written 0 1 0` where the module has no input.
 */
function answerOf(line: string): ModuleAnswer | undefined {
	if (line === "") return undefined;
	const numbers = (text: string) => text.split(" ").filter(Boolean);
	if (line.startsWith("written")) return { answered: numbers(line.slice("written".length)) };
	const arrow = line.indexOf("→");
	const semicolon = line.indexOf(";", arrow);
	const end = semicolon < 0 ? line.length : semicolon;
	const words = line
		.slice(end + 1)
		.trim()
		.replaceAll("; ", " ");
	return {
		asked: numbers(line.slice("asked".length, arrow)),
		answered: numbers(line.slice(arrow + 1, end)),
		...(words ? { words } : {}),
	};
}
