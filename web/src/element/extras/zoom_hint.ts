/** The hint over the view on how to zoom with the wheel, shown when the wheel has scrolled the page instead. */
import { text } from "../messages.generated";

/** Duration of the hint, ms. */
const DURATION = 2000;

const STYLE = `
	.zoom-hint {
		inset: 50% auto auto 50%;
		translate: -50% -50%;
		box-sizing: border-box;
		width: max-content;
		max-width: 100%;
		border: 1px solid;
		border-radius: 6px;
		text-align: center;
		pointer-events: none;
	}
`;

const hints = new WeakMap<ShadowRoot, { hint: HTMLElement; timer: number }>();

/** Shows the hint for two seconds in the shadow tree of an element. */
export function showZoomHint(root: ShadowRoot): void {
	const shown = hints.get(root);
	const hint = shown?.hint ?? createHint(root);
	clearTimeout(shown?.timer);
	const timer = window.setTimeout(() => (hint.hidden = true), DURATION);
	hints.set(root, { hint, timer });
	hint.textContent = text("zoom_hint", { key: /Mac/.test(navigator.platform) ? "⌘" : "Ctrl" });
	hint.hidden = false;
}

/** Adds the hint and its style to the shadow tree; screen readers have the keys of the view instead. */
function createHint(root: ShadowRoot): HTMLElement {
	const style = new CSSStyleSheet();
	style.replaceSync(STYLE);
	root.adoptedStyleSheets.push(style);
	const hint = Object.assign(document.createElement("p"), { className: "zoom-hint", ariaHidden: "true" });
	hint.part.add("hint");
	root.append(hint);
	return hint;
}
