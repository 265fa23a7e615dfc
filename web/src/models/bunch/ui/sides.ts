import { html } from "lit";
import { icon } from "../../../ui/icons";
import { text } from "../messages.generated";
import { mirrorFrontBack, mirrorLeftRight, withOpposites } from "../profile/drag";
import { type BunchShape, type Locks, SIDES } from "../profile/handles";
import type { BunchSpecimen } from "../specimen";
import type { BunchContext, BunchTool } from "./context";
import { MIRROR } from "./icons";

type Pair = keyof Locks;

/** Tool that locks the two sides of a pair, or swaps them. */
export const sides: BunchTool<Locks> = {
	name: "sides",
	initial: { leftRight: false, frontBack: false },
	recall: (stored) => {
		const { leftRight, frontBack } = (stored ?? {}) as Partial<Record<Pair, unknown>>;
		return { leftRight: leftRight === true, frontBack: frontBack === true };
	},
	// A change of both sides of a pair stays as it is.
	follow: ({ parameters, ...change }, context) =>
		parameters
			? { ...change, parameters: withOpposites(parameters as Partial<BunchShape>, context.toolState(sides)) }
			: change,
	panel: { group: "shape", place: "below", draw },
};

/** Locks or unlocks a pair; locking equalises its sides at once, so that the view shows the locked state. */
export function toggleLock(context: BunchContext, pair: Pair): void {
	const locks = context.toolState(sides);
	context.setToolState(sides, { ...locks, [pair]: !locks[pair] });
	if (!locks[pair]) context.set({ parameters: equalised(context.state.specimen, pair) });
}

/** Returns the numbers that make the sides of a pair equal: right copied to left, or front to back. */
function equalised({ parameters }: BunchSpecimen, pair: Pair): Partial<BunchShape> {
	const side = pair === "leftRight" ? "p3" : "p5";
	const { opposite } = SIDES[side];
	return { [`${opposite}w`]: parameters[`${side}w`], [`${opposite}r`]: parameters[`${side}r`] };
}

/** Swaps the two sides of a pair; sets every number, so that locks change nothing. */
export function mirror(context: BunchContext, pair: Pair): void {
	const { parameters } = context.state.specimen;
	context.set({ parameters: pair === "leftRight" ? mirrorLeftRight(parameters) : mirrorFrontBack(parameters) });
}

const PAIRS = [
	["leftRight", "lock_left_right", "mirror_left_right"],
	["frontBack", "lock_front_back", "mirror_front_back"],
] as const;

/** Renders buttons that lock opposite sides together, and buttons that swap them. */
function draw(context: BunchContext): unknown {
	const locks = context.toolState(sides);
	return html`<div class="actions">
		${PAIRS.map(
			([pair, lock]) => html`<button
				class="button" type="button" aria-pressed=${locks[pair]} @click=${() => toggleLock(context, pair)}
			>${text(lock)}</button>`,
		)}
		${PAIRS.map(
			([pair, , label]) => html`<button class="button" type="button" @click=${() => mirror(context, pair)}
			>${icon(MIRROR)}${text(label)}</button>`,
		)}
	</div>`;
}
