import type { Page } from "@playwright/test";
import { MODEL_VIEWER } from "../../web/src/app/files/embed_code";

/** A stub of Google's viewer: it fetches its file and reports the size. */
const STAND_IN = `customElements.define("model-viewer", class extends HTMLElement {
	async connectedCallback() {
		const bytes = await (await fetch(this.getAttribute("src"))).arrayBuffer();
		const json = new TextDecoder().decode(new Uint8Array(bytes, 20, new DataView(bytes).getUint32(12, true)));
		this.gltf = JSON.parse(json);
	}
});`;

/** Answers requests to the host of Google's viewer, so that tests do not use the network. */
export async function standInForModelViewer(page: Page): Promise<void> {
	const headers = { "access-control-allow-origin": "*" };
	await page.route(MODEL_VIEWER, (route) => route.fulfill({ contentType: "text/javascript", body: STAND_IN, headers }));
}
