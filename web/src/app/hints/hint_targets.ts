/** The elements of the page that the hints are about, and the elements that a hint must not cover. */
import type { HintKey } from "./hint_store";
import type { ScreenBox } from "./place_hint";

/** A target of a hint that is on the page. */
export interface HintTarget {
	/** Takes the focus when the hint is dismissed by a key. */
	readonly element: HTMLElement;
	readonly box: ScreenBox;
	/** The key of the hint's text. */
	readonly text: "point" | "point_views" | "turn" | "turn_touch" | "play";
	/** Whether a ring marks the target. */
	readonly marked: boolean;
}

/**
 * Controls in the views and in notices over them. Those beside the views are left out: presets that are scrolled out of
 * the strip have places within the views.
 */
const CONTROLS =
	":is(main, .notices) :is(button, a[href], input, select, textarea, summary, [role=button], [role=slider], .switch)";
const OTHERS = ".caption, .scale-bar, .stage-warnings p, .stage-chip, .growing, .editor, .notice, .explain";

/** Returns the target of a hint; undefined if the page does not show one, since the plant has none or a view is hidden. */
export function targetOf(key: HintKey, page: HTMLElement): HintTarget | undefined {
	if (key === "point") return pointTarget(page);
	if (key === "turn") return turnTarget(page);
	const play = page.querySelector<HTMLElement>("panicle-bars .play");
	return play && isVisible(play) ? { element: play, box: boxOf(play), text: "play", marked: true } : undefined;
}

/** Returns the controls and the other elements that a hint must or should not cover. */
export function obstaclesOn(page: HTMLElement): {
	readonly controls: readonly ScreenBox[];
	readonly others: readonly ScreenBox[];
} {
	const boxes = (elements: Iterable<HTMLElement>) => [...elements].filter(isVisible).map(boxOf);
	return {
		controls: boxes([...page.querySelectorAll<HTMLElement>(CONTROLS), ...handlesIn(page)]),
		others: boxes(page.querySelectorAll<HTMLElement>(OTHERS)),
	};
}

/** Returns the area that hints may cover: the views, as far as they are in the window. */
export function areaOn(page: HTMLElement): ScreenBox {
	const { left, top, right, bottom } = (page.querySelector("main") ?? page).getBoundingClientRect();
	const [start, above] = [Math.max(0, left), Math.max(0, top)];
	return {
		left: start,
		top: above,
		width: Math.min(innerWidth, right) - start,
		height: Math.min(innerHeight, bottom) - above,
	};
}

/** Returns whether an event happened at a handle of a flat view. */
export const isAtHandle = (event: Event): boolean =>
	event.composedPath().some((each) => each instanceof Element && each.hasAttribute("data-handle"));

/**
 * Returns the point of a flat view that is nearest to the 3-D view; on a phone with the 3-D view, the choice of the
 * views. Undefined where there is neither.
 */
function pointTarget(page: HTMLElement): HintTarget | undefined {
	const handles = handlesIn(page).filter(isVisible);
	const rightmost = handles.sort((a, b) => boxOf(b).left - boxOf(a).left)[0];
	if (rightmost) return { element: rightmost, box: boxOf(rightmost), text: "point", marked: true };
	const views = page.querySelector<HTMLElement>("panicle-view-switch .switch");
	const choice = views?.querySelector<HTMLElement>("input");
	if (!views || !choice || !isVisible(views) || handlesIn(page).length === 0) return undefined;
	return { element: choice, box: boxOf(views), text: "point_views", marked: true };
}

/** Returns the lower corner of the 3-D view, beside the plant; undefined where the view is hidden. */
function turnTarget(page: HTMLElement): HintTarget | undefined {
	const element = page.querySelector<HTMLElement>(".stage-surface");
	if (!element || !isVisible(element)) return undefined;
	const { left, top, width, height } = boxOf(element);
	const isMirrored = getComputedStyle(element).direction === "rtl";
	const box = { left: isMirrored ? left + width : left, top: top + height, width: 0, height: 0 };
	return { element, box, text: isTouch() ? "turn_touch" : "turn", marked: false };
}

/** Returns whether the main pointer is a finger, which cannot scroll with a wheel. */
const isTouch = (): boolean => matchMedia("(pointer: coarse)").matches;

/** Returns the handles of all flat views, which are in shadow trees. */
function handlesIn(page: HTMLElement): readonly HTMLElement[] {
	const editors = page.querySelector("panicle-editors");
	return editors ? deepHandles(editors) : [];
}

/** Returns the handles below an element, also those in shadow trees at any depth. */
function deepHandles(root: ParentNode): HTMLElement[] {
	const own = [...root.querySelectorAll<HTMLElement>("[data-handle]")];
	const inside = [...root.querySelectorAll("*")].flatMap(({ shadowRoot }) =>
		shadowRoot ? deepHandles(shadowRoot) : [],
	);
	return [...own, ...inside];
}

/** Returns the place of an element in the window. */
const boxOf = (element: Element): ScreenBox => element.getBoundingClientRect();

/** Returns whether an element has a place on the page, in the window. */
function isVisible(element: HTMLElement): boolean {
	const { left, top, right, bottom } = element.getBoundingClientRect();
	const isInWindow = right > 0 && bottom > 0 && left < innerWidth && top < innerHeight && right > left && bottom > top;
	return isInWindow && element.checkVisibility({ visibilityProperty: true });
}
