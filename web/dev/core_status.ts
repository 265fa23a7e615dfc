/**
 * For the development server alone: a message over the view while the core of a model is being built that this page, or
 * another one, has requested.
 * The server sends the event `panicle:core` (wasm-core/tools/vite_plugin.mjs).
 */
interface CoreState {
	readonly model: string;
	readonly state: "building" | "ready" | "failed";
}

const building = new Set<string>();
const message = document.createElement("p");
message.setAttribute("role", "status");
message.style.cssText =
	"position:fixed;inset:8rem auto auto 50%;transform:translateX(-50%);z-index:1000;pointer-events:none;" +
	"margin:0;padding:.6rem 1rem;border-radius:.5rem;width:max-content;" +
	"background:#2b2320;color:#f4efe4;font:14px/1.4 system-ui,sans-serif;max-width:calc(100vw - 4rem)";

function show(): void {
	const models = [...building].join(", ");
	message.textContent = models && `Building the core of ${models}. Plants that need it appear when it is ready.`;
	message.hidden = models === "";
}

import.meta.hot?.on("panicle:core", ({ model, state }: CoreState) => {
	if (state === "building") building.add(model);
	else building.delete(model);
	show();
	if (!message.isConnected) document.body.append(message);
});
