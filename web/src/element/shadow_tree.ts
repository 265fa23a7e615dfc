/** Builds the element's shadow tree: a canvas, a poster until it is drawn, and a message for errors. */
import { orbitKeys } from "../render/orbit_keys";
import { ELEMENT_STYLE } from "./element_style";
import { text } from "./messages.generated";

export interface ShadowTree {
	readonly root: ShadowRoot;
	readonly canvas: HTMLCanvasElement;
	readonly poster: HTMLImageElement;
	readonly message: HTMLElement;
	/** Writes the texts, in the language in use. */
	describe(): void;
}

/**
 * Attaches the shadow tree to an element. `describe` sets texts for screen readers again, after the language has
 * changed.
 */
export function shadowTree(host: HTMLElement): ShadowTree {
	const root = host.attachShadow({ mode: "open", delegatesFocus: true });
	const style = new CSSStyleSheet();
	style.replaceSync(ELEMENT_STYLE);
	root.adoptedStyleSheets = [style];
	const canvas = Object.assign(document.createElement("canvas"), { tabIndex: 0, role: "application" });
	canvas.setAttribute("aria-describedby", "keys");
	const poster = Object.assign(document.createElement("img"), { alt: "" });
	const message = Object.assign(document.createElement("p"), { hidden: true, role: "alert" });
	const keys = Object.assign(document.createElement("p"), { id: "keys", className: "unseen" });
	const describe = () => {
		canvas.setAttribute("aria-roledescription", text("view"));
		keys.textContent = orbitKeys();
	};
	describe();
	canvas.part.add("view");
	poster.part.add("poster");
	message.part.add("message");
	root.append(canvas, poster, message, keys);
	return { root, canvas, poster, message, describe };
}
