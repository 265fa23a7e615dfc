/** The application's start: wires the store to the worker, the address bar and the page, and nothing else. */
import coreUrl from "../../../build/core/bunch.wasm?url";
import { Client } from "../core/client";
import { presetNamed } from "../models/bunch/presets/index";
import { readGrown } from "../models/bunch/read_grown";
import { encodeRequest } from "../models/bunch/request";
import { readAddress, readWholeAddress, writeAddress } from "./address";
import { AgePlayer } from "./age_player";
import { Growing } from "./growing";
import { listenForShortcuts } from "./shortcuts";
import { loadScene } from "./solid_view";
import { Studio } from "./studio";
import { applyTheme, onSystemTheme } from "./theme";
import { loadUi, saveUi } from "./ui_state";
import "./parts/stage";
import type { Help } from "./parts/help";
import type { StudioElement } from "./parts/studio_element";
import "./parts/age_bar";
import "./parts/drop";
import "./parts/gallery";
import "./parts/help";
import "./parts/history_bar";
import "./parts/notices";
import "./parts/panel";
import "./parts/profiles";
import "./parts/share_bar";
import "./parts/speaker";
import "./parts/variation";
import "./parts/view_switch";

// The core's fetch, its worker and the 3-D view's script start together; the page is drawn meanwhile.
const client = new Client({ onNote: (text) => console.info(text) });
client.warm(coreUrl);
const growing = new Growing(
	{
		grow: async (specimen, { signal, ...options } = {}) => {
			const order = { wasm: coreUrl, blocks: encodeRequest(specimen, options) };
			return readGrown(await client.grow(order, signal ? { signal } : {}));
		},
	},
	() => studio,
);
void loadScene();

const ui = loadUi(localStorageOr());
applyTheme(ui.theme);

const opened = readAddress(location);
const studio = new Studio(opened.specimen, ui, {
	grow: (specimen, options) => void growing.grow(specimen, options),
	cancel: () => growing.cancel(),
	settled: (specimen) => void writeAddress(specimen),
	remember: (next) => {
		saveUi(localStorageOr(), next);
		applyTheme(next.theme);
	},
});

/** The parts that draw the studio, by their tags in index.html. */
const PARTS = [
	"panicle-history",
	"panicle-variation",
	"panicle-share",
	"panicle-view-switch",
	"panicle-stage",
	"panicle-profiles",
	"panicle-age",
	"panicle-gallery",
	"panicle-panel",
	"panicle-notices",
	"panicle-drop",
	"panicle-help",
	"panicle-speaker",
].join();

start();

function start(): void {
	// Asked for before the parts are drawn, the bunch grows meanwhile; a grammar has to be unpacked first.
	if (opened.whole) studio.open(opened, "link");
	else void readWholeAddress(location).then((whole) => studio.open(whole, "link"));
	for (const part of document.querySelectorAll<StudioElement>(PARTS)) part.studio = studio;
	const help = document.querySelector<Help>("panicle-help");
	document.addEventListener("panicle-help", () => help?.open());
	new AgePlayer(studio);
	listenForShortcuts(studio, () => help?.open());
	onSystemTheme(() => studio.setUi({}));
	studio.subscribe(nameTab);
	addEventListener("popstate", () => void follow());
}

/** Tabs and bookmarks are told apart by what they hold. */
function nameTab(): void {
	const { preset, seed } = studio.state.specimen;
	document.title = `${presetNamed(preset)?.title ?? "Grape bunch"} ${seed} · Panicle`;
}

/** The address is another one: by Back, Forward or by hand. */
async function follow(): Promise<void> {
	studio.take(await readWholeAddress(location), "link");
}

/** Storage that forgets, where the browser forbids it. */
function localStorageOr(): Pick<Storage, "getItem" | "setItem"> {
	try {
		return localStorage;
	} catch {
		return { getItem: () => null, setItem: () => {} };
	}
}
