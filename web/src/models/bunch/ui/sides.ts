import { html } from "lit";
import { icon } from "../../../ui/icons";
import { mirrorFrontBack, mirrorLeftRight, withOpposites } from "../profile/drag";
import { type Locks, type Shape, SIDES } from "../profile/handles";
import type { BunchSpecimen } from "../specimen";
import type { BunchContext, BunchTool } from "./context";
import { MIRROR } from "./icons";

type Pair = keyof Locks;

/** Whether the two sides of a pair move as one, and what exchanges them. */
export const sides: BunchTool<Locks> = {
	name: "sides",
	initial: { leftRight: false, frontBack: false },
	recall: (stored) => {
		const { leftRight, frontBack } = (stored ?? {}) as Partial<Record<Pair, unknown>>;
		return { leftRight: leftRight === true, frontBack: frontBack === true };
	},
	// A change that names both sides of a pair is left alone.
	follow: ({ parameters, ...change }, context) =>
		parameters
			? { ...change, parameters: withOpposites(parameters as Partial<Shape>, context.toolState(sides)) }
			: change,
	panel: { group: "shape", place: "below", draw },
};

/** Locking brings the two sides together at once, so that what is shown is what is locked. */
export function toggleLock(context: BunchContext, pair: Pair): void {
	const locks = context.toolState(sides);
	context.setToolState(sides, { ...locks, [pair]: !locks[pair] });
	if (!locks[pair]) context.set({ parameters: brought(context.state.specimen, pair) });
}

/** Left takes right's numbers, back takes front's. */
function brought({ parameters }: BunchSpecimen, pair: Pair): Partial<Shape> {
	const side = pair === "leftRight" ? "p3" : "p5";
	const { opposite } = SIDES[side];
	return { [`${opposite}w`]: parameters[`${side}w`], [`${opposite}r`]: parameters[`${side}r`] };
}

/** Exchanges the two sides of a pair; every number is named, so that locks have nothing to add. */
export function mirror(context: BunchContext, pair: Pair): void {
	const { parameters } = context.state.specimen;
	context.set({ parameters: pair === "leftRight" ? mirrorLeftRight(parameters) : mirrorFrontBack(parameters) });
}

const PAIRS = [
	["leftRight", "left–right"],
	["frontBack", "front–back"],
] as const;

function draw(context: BunchContext): unknown {
	const locks = context.toolState(sides);
	return html`<div class="actions">
		${PAIRS.map(
			([pair, words]) => html`<button
				class="button" type="button" aria-pressed=${locks[pair]} @click=${() => toggleLock(context, pair)}
			>Lock ${words}</button>`,
		)}
		${PAIRS.map(
			([pair, words]) => html`<button class="button" type="button" @click=${() => mirror(context, pair)}
			>${icon(MIRROR)}Mirror ${words}</button>`,
		)}
	</div>`;
}
