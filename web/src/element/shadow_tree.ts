/** Builds the element's shadow tree: a canvas, a poster until it is drawn, and a message for errors. */
import { ORBIT_KEYS } from "../render/orbit_keys";
import { ELEMENT_STYLE } from "./element_style";

export interface ShadowTree {
	readonly root: ShadowRoot;
	readonly canvas: HTMLCanvasElement;
	readonly poster: HTMLImageElement;
	readonly message: HTMLElement;
}

export function shadowTree(host: HTMLElement): ShadowTree {
	const root = host.attachShadow({ mode: "open", delegatesFocus: true });
	const style = new CSSStyleSheet();
	style.replaceSync(ELEMENT_STYLE);
	root.adoptedStyleSheets = [style];
	const canvas = Object.assign(document.createElement("canvas"), { tabIndex: 0, role: "application" });
	canvas.setAttribute("aria-roledescription", "3-D view");
	canvas.setAttribute("aria-describedby", "keys");
	const poster = Object.assign(document.createElement("img"), { alt: "" });
	const message = Object.assign(document.createElement("p"), { hidden: true, role: "alert" });
	const keys = Object.assign(document.createElement("p"), { id: "keys", className: "unseen", textContent: ORBIT_KEYS });
	canvas.part.add("view");
	poster.part.add("poster");
	message.part.add("message");
	root.append(canvas, poster, message, keys);
	return { root, canvas, poster, message };
}
