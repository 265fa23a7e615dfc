/** The application's start: wires the store to the core, the address bar and the page, and nothing else. */

import { Client } from "../core/client";
import { coreAddress } from "../core/core_address";
import { DEFAULT_MODEL, isModel, modelNamed, modelNames } from "../models/index";
import type { PageModel } from "../models/page_model";
import { loadRenderer, loadScene } from "../models/renderers";
import { allBut } from "../specimen/all_but";
import { changed } from "../ui/changed";
import { AddressBar, isForeign, modelInAddress, readAddress, readWholeAddress } from "./address";
import { AppUpdater } from "./app_updater";
import { CoreGrower } from "./core_grower";
import { Growing } from "./growing";
import { openLate } from "./late_link";
import { runningBy } from "./panel_groups";
import { HELP, SAVED } from "./parts/late_parts";
import { openPart } from "./parts/open_part";
import type { StudioPart } from "./parts/studio_part";
import { listenForShortcuts } from "./shortcuts";
import { listenForSkips } from "./skips";
import { Studio } from "./studio";
import { applyTheme, isSystemDark, onSystemTheme } from "./theme";
import { titleOf } from "./title";
import { loadUi, pageOf, STORAGE_KEY, saveUi } from "./ui_state";
import "./parts/stage";
import "./parts/bars";
import "./parts/drop";
import "./parts/editors";
import "./parts/gallery";
import "./parts/history_bar";
import "./parts/notices";
import "./parts/pane";
import "./parts/panel";
import "./parts/share_bar";
import "./parts/speaker";
import "./parts/variation";
import "./parts/view_switch";

/** The parts that draw the studio, by their tags in index.html. */
const PARTS = [
	"panicle-history",
	"panicle-variation",
	"panicle-share",
	"panicle-view-switch",
	"panicle-stage",
	"panicle-editors",
	"panicle-pane",
	"panicle-bars",
	"panicle-gallery",
	"panicle-panel",
	"panicle-notices",
	"panicle-drop",
	"panicle-saved",
	"panicle-help",
	"panicle-speaker",
].join();

// The link's model, its core and the 3-D view's script start together; the page is drawn meanwhile.
const requestedModel = modelInAddress(location) ?? DEFAULT_MODEL;
const cores = new CoreGrower(coreAddress);
cores.warm(`${isModel(requestedModel) ? requestedModel : DEFAULT_MODEL}.wasm`);
loadScene().catch(() => {}); // The stage asks again, and says why not.
const ui = loadUi(localStorageOr());
applyTheme(ui.theme);
modelNamed(requestedModel).then(start, refuse);

function start(model: PageModel): void {
	cores.warm(model.wasm); // Of a family it is not named after the model.
	loadRenderer(model).catch(() => {}); // The stage asks again, and says why not.
	// A core's client grows what it was asked last: what is looked for is not to take the place of what is shown.
	const searching = new CoreGrower(coreAddress, new Client());
	// Its worker starts when something is first asked of it.
	const offscreen = new CoreGrower(coreAddress, new Client());
	const growing = new Growing(cores, () => studio);
	const bar = new AddressBar();
	const opened = readAddress(model, location);
	const { specimen } = opened;
	const studio = new Studio(
		{ model, specimen, ui, systemDark: isSystemDark() },
		{
			grow: (of, each, options) => void growing.grow(of, each, options),
			measure: async (of, each, signal) =>
				(await searching.grow(of, each, { meshes: false, measures: true, signal })).measures ?? new Float32Array(),
			growOffscreen: async (each, options) =>
				offscreen.grow(await modelNamed(each.model), each, { meshes: false, measures: false, ...options }),
			cancel: () => growing.cancel(),
			settled: (of, each) => void bar.write(of, each),
			remember: (next, before) => {
				saveUi(localStorageOr(), next, before);
				applyTheme(next.theme);
			},
		},
	);
	// Asked for before the parts are drawn, the plant grows meanwhile; a text in the fragment has to be unpacked first.
	if (opened.whole) studio.open(opened, "link");
	else void openLate(studio, readWholeAddress(model, location));
	draw(studio);
	followFirst(studio, growing, startUpdater(studio));
	listenForSkips();
	followOtherTabs(studio);
	addEventListener("popstate", () => void follow(studio, bar));
}

function draw(studio: Studio): void {
	for (const part of document.querySelectorAll<StudioPart>(PARTS)) part.context = studio;
	const help = () => void openPart(studio, HELP);
	document.addEventListener("panicle-help", help);
	listenForShortcuts(studio, { help, saved: () => void openPart(studio, SAVED) });
	onSystemTheme((dark) => studio.setSystemDark(dark));
	// Tabs and bookmarks are told apart by what they hold.
	let named: readonly unknown[] | undefined;
	const nameTab = () => {
		const { model, specimen, modelUi, tools } = studio.state;
		const shown = [model, modelUi, tools, ...allBut(specimen, runningBy(modelUi?.tools))];
		if (named && !changed(named, shown)) return;
		named = shown;
		document.title = `${titleOf(specimen, model, modelUi?.tools)} ${specimen.seed} · Panicle`;
	};
	nameTab();
	studio.subscribe(nameTab);
}

/** What one tab chooses of the page holds in all. */
function followOtherTabs(studio: Studio): void {
	addEventListener("storage", ({ key }) => {
		if (key !== null && key !== STORAGE_KEY) return;
		studio.setUi(pageOf(loadUi(localStorageOr())));
	});
}

/** Keeps the built app for when there is no network, and offers its next version. What is worked on changes by the minute. */
function startUpdater(studio: Studio): AppUpdater | undefined {
	if (!import.meta.env.PROD) return undefined;
	const details = ["Reload when it suits: the plant stays as it is, its steps of Undo go."];
	const updater = new AppUpdater((reload) => {
		studio.notify("A new version is here", details, { topic: "version", act: { words: "Reload", run: reload } });
	});
	// What can be tried again may be gone for good. Vite's own event is of the scripts, whoever asked for them.
	addEventListener("vite:preloadError", () => void updater.look());
	let before = studio.state;
	studio.subscribe(() => {
		const { notices, failure } = studio.state;
		const offersRetry = notices.some((notice) => notice.again && !before.notices.includes(notice));
		if (offersRetry || (failure && failure !== before.failure)) void updater.look();
		before = studio.state;
	});
	return updater;
}

/** Once the first plant is drawn, or is known not to come, what was a sketch of it follows, and the gallery gets every model's presets. */
function followFirst(studio: Studio, growing: Growing, updater: AppUpdater | undefined): void {
	const end = studio.subscribe(async () => {
		const { shown, failure } = studio.state;
		if (!shown && !failure) return;
		end();
		if (shown) await drawn();
		growing.finish();
		void Promise.allSettled(modelNames().map((name) => modelNamed(name))).then((models) => {
			studio.list(models.flatMap((model) => (model.status === "fulfilled" ? [model.value] : [])));
			updater?.start().catch(() => {}); // Then the app needs its network, as before.
		});
	});
}

/** Where nothing is drawn within this time the gallery waits no longer; milliseconds. */
const LONGEST_WAIT = 3000;

/** Settles when the view has drawn its first plant. */
function drawn(): Promise<void> {
	return new Promise((resolve) => {
		new PerformanceObserver((list, observer) => {
			if (list.getEntriesByName("first-bunch").length === 0) return;
			observer.disconnect();
			resolve();
		}).observe({ type: "mark", buffered: true });
		setTimeout(resolve, LONGEST_WAIT);
	});
}

let followed = 0;

/** The address is another one: by Back, Forward or by hand. */
async function follow(studio: Studio, bar: AddressBar): Promise<void> {
	const turn = ++followed;
	const { search, hash } = location;
	try {
		const model = await modelNamed(modelInAddress({ search }));
		if (isForeign(model, { hash })) {
			// A place in the page, or nothing of ours: the document stays, and the address is again its own.
			const { model: present, specimen } = studio.state;
			await bar.write(present, specimen);
			return;
		}
		const restored = await readWholeAddress(model, { search, hash });
		if (turn !== followed) return;
		bar.arrived(restored.specimen);
		studio.visit(model, restored, "link");
	} catch {
		studio.notify("The link could not be followed", [
			"Part of this page could not be fetched; check the connection and load the page again.",
		]);
	}
}

/** Not even the model has come, so there is nothing to draw the page from. */
function refuse(): void {
	const words = document.createElement("p");
	words.className = "noscript";
	words.role = "alert";
	words.textContent = "Part of this page could not be fetched; check the connection and load it again.";
	document.querySelector("main")?.append(words);
}

/** Storage that forgets, where the browser forbids it. */
function localStorageOr(): Pick<Storage, "getItem" | "setItem"> {
	try {
		return localStorage;
	} catch {
		return { getItem: () => null, setItem: () => {} };
	}
}
