/**
 * Derivation trace of Lindenmayer's algae (A → AB, B → A), computed here in the core's format: a test source of
 * traces.
 */
import type { DerivationTrace, ModuleSpan, TraceRequest } from "../../../web/src/plant/derivation_trace";

interface Written {
	readonly text: string;
	readonly parent?: number;
	children: ModuleSpan;
}

/** Lines of the two productions. */
const LINE: Readonly<Record<string, number>> = { A: 3, B: 4 };

function stringsOf(steps: number): Written[][] {
	const strings: Written[][] = [[{ text: "A", children: { first: 0, count: 0 } }]];
	for (let step = 0; step < steps; step++) {
		const next: Written[] = [];
		strings[step].forEach((module, parent) => {
			const becomes = module.text === "A" ? ["A", "B"] : ["A"];
			module.children = { first: next.length, count: becomes.length };
			for (const text of becomes) next.push({ text, parent, children: { first: 0, count: 0 } });
		});
		strings.push(next);
	}
	return strings;
}

/** Returns the trace as the core reports it, with one segment for each module of the last string, in order. */
export function algae({ step, first = 0, count = 2000, module }: TraceRequest, steps: number): DerivationTrace {
	const strings = stringsOf(steps);
	const at = Math.min(step, steps);
	const descendants = (index: number): ModuleSpan => {
		let [from, to] = [index, index + 1];
		for (let each = at; each < steps; each++) {
			const { first: last, count: width } = strings[each][to - 1].children;
			[from, to] = [strings[each][from].children.first, last + width];
		}
		return { first: from, count: to - from };
	};
	const place = (text: string) => ({ line: LINE[text], column: 1 });
	const trail: number[] = [];
	if (module !== undefined) {
		for (let each = steps, index = module; each >= 0; index = strings[each][index].parent ?? 0, each--)
			trail.unshift(index);
	}
	return {
		counts: Uint32Array.from(strings, ({ length }) => length),
		step: at,
		first,
		modules: strings[at].slice(first, first + count).map(({ text, parent, children }, index) => ({
			text,
			...(parent === undefined ? {} : { parent, production: place(strings[at - 1][parent].text) }),
			...(at < steps ? { fires: place(text) } : {}),
			values: [],
			children,
			last: descendants(first + index),
		})),
		...(module === undefined ? {} : { trail: Uint32Array.from(trail) }),
		segments: Uint32Array.from(strings[steps].keys()),
		organs: new Uint32Array(0),
	};
}
