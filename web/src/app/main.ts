/** Starts the application: connects the studio to the core, the address bar and the page. */

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
import { PageGrowth } from "./growing";
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

// Fetch the link's model, its core and the 3-D view's script in parallel; the page is drawn meanwhile.
const requestedModel = modelInAddress(location) ?? DEFAULT_MODEL;
const cores = new CoreGrower(coreAddress);
cores.warm(`${isModel(requestedModel) ? requestedModel : DEFAULT_MODEL}.wasm`);
loadScene().catch(() => {}); // The stage tries again and reports the error.
const ui = loadUi(localStorageOr());
applyTheme(ui.theme);
modelNamed(requestedModel).then(start, refuse);

function start(model: PageModel): void {
	cores.warm(model.wasm); // Models of a family share a core of another name.
	loadRenderer(model).catch(() => {}); // The stage tries again and reports the error.
	// A client drops all but the newest request: searches need a client of their own.
	const searching = new CoreGrower(coreAddress, new Client());
	// The worker starts with the first request.
	const offscreen = new CoreGrower(coreAddress, new Client());
	const growing = new PageGrowth(cores, () => studio);
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
	// Request the growth before the parts are drawn; a text in the fragment has to be unpacked first.
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
	// The tab's title names the plant.
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

/** Applies the theme and the keyboard setting that another tab has chosen. */
function followOtherTabs(studio: Studio): void {
	addEventListener("storage", ({ key }) => {
		if (key !== null && key !== STORAGE_KEY) return;
		studio.setUi(pageOf(loadUi(localStorageOr())));
	});
}

/** Stores the built app for offline use and offers new versions; not in development. */
function startUpdater(studio: Studio): AppUpdater | undefined {
	if (!import.meta.env.PROD) return undefined;
	const details = ["Reload when it suits: the plant stays as it is, its steps of Undo go."];
	const updater = new AppUpdater((reload) => {
		studio.notify("A new version is here", details, { topic: "version", act: { words: "Reload", run: reload } });
	});
	// A script that cannot be fetched may belong to a version that the host no longer has. Vite's event reports every failed import.
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

/** After the first plant is drawn or has failed: replaces its sketch, fills the gallery with every model's presets, starts the updater. */
function followFirst(studio: Studio, growing: PageGrowth, updater: AppUpdater | undefined): void {
	const end = studio.subscribe(async () => {
		const { shown, failure } = studio.state;
		if (!shown && !failure) return;
		end();
		if (shown) await drawn();
		growing.finish();
		void Promise.allSettled(modelNames().map((name) => modelNamed(name))).then((models) => {
			studio.list(models.flatMap((model) => (model.status === "fulfilled" ? [model.value] : [])));
			updater?.start().catch(() => {}); // Then the app works online only.
		});
	});
}

/** Longest time that the gallery waits for the first draw; milliseconds. */
const LONGEST_WAIT = 3000;

/** Resolves when the view has drawn its first plant, or after LONGEST_WAIT. */
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

/** Follows a change of the address by Back, Forward or typing. */
async function follow(studio: Studio, bar: AddressBar): Promise<void> {
	const turn = ++followed;
	const { search, hash } = location;
	try {
		const model = await modelNamed(modelInAddress({ search }));
		if (isForeign(model, { hash })) {
			// The fragment is no document: keep the document and restore its address.
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

/** Reports that the model could not be fetched, without which the page cannot be drawn. */
function refuse(): void {
	const words = document.createElement("p");
	words.className = "noscript";
	words.role = "alert";
	words.textContent = "Part of this page could not be fetched; check the connection and load it again.";
	document.querySelector("main")?.append(words);
}

/** The browser's local storage; where it is forbidden, a storage that is always empty. */
function localStorageOr(): Pick<Storage, "getItem" | "setItem"> {
	try {
		return localStorage;
	} catch {
		return { getItem: () => null, setItem: () => {} };
	}
}
