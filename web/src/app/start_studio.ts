/** Starts the studio: connects it to the core, the address bar and the page. */

import { Client } from "../core/client";
import { coreAddress } from "../core/core_address";
import { DEFAULT_MODEL, isModel, modelNamed, modelNames } from "../models/index";
import type { PageModel } from "../models/page_model";
import { loadRenderer, loadScene } from "../models/renderers";
import { allBut } from "../specimen/all_but";
import type { Restored } from "../specimen/restore";
import { changed } from "../ui/changed";
import { AddressBar, isForeign, modelInAddress, readAddress, readWholeAddress } from "./address";
import { namesPlant } from "./address_plant";
import { AppUpdater } from "./app_updater";
import { CoreGrower } from "./core_grower";
import { takeFile } from "./files/drops";
import { firstDrawing } from "./first_drawing";
import { PageGrowth } from "./growing";
import { hintsDue } from "./hints/hint_store";
import type { Hints } from "./hints/hints";
import { openLate } from "./late_link";
import { localStorageOr } from "./local_storage";
import { text } from "./messages.generated";
import { describePage } from "./page_description";
import { runningBy } from "./panel_groups";
import { HELP, HINTS } from "./parts/late_parts";
import { openPart } from "./parts/open_part";
import type { StudioPart } from "./parts/studio_part";
import { described, pictureOf } from "./preset_cards";
import { recentInAddress } from "./recent/recent_address";
import { refuse } from "./refuse";
import { listenForShortcuts } from "./shortcuts";
import { listenForSkips } from "./skips";
import { Studio } from "./studio";
import { applyTheme, isSystemDark, onSystemTheme } from "./theme";
import { titleOf } from "./title";
import { fetchFailed } from "./types";
import { loadUi, pageOf, STORAGE_KEY, saveUi, type UiState } from "./ui_state";
import "./style/studio.css";
import "./parts/stage";
import "./parts/bars";
import "./parts/drop";
import "./parts/editors";
import "./parts/family_switch";
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
	"panicle-family",
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
	"panicle-browse",
	"panicle-help",
	"panicle-hints",
	"panicle-shortcuts",
	"panicle-share-sheet",
	"panicle-downloads",
	"panicle-batch",
	"panicle-embed",
	"panicle-palette",
	"panicle-speaker",
].join();

/**
 * Starts the studio with the plant of the address.
 * @param ui the interface state of the last visit
 * @param language resolves when the language is loaded; models build their tables in it
 * @param file a file to open at once
 */
export async function start(ui: UiState, language: Promise<void>, file?: File): Promise<void> {
	// Fetch the link's model, its core and the 3-D view's script in parallel; the page is drawn meanwhile.
	const requestedModel = modelInAddress(location) ?? DEFAULT_MODEL;
	const cores = new CoreGrower(coreAddress);
	cores.warm(`${isModel(requestedModel) ? requestedModel : DEFAULT_MODEL}.wasm`);
	loadScene().catch(() => {}); // The stage tries again and reports the error.
	document.querySelector<HTMLElement>(".studio")?.removeAttribute("hidden");
	await language;
	const model = await modelNamed(requestedModel).catch(refuse);
	if (!model) return;
	const studio = startWith(model, cores, ui);
	if (file) await takeFile(studio, file);
}

/** Creates the studio for a model, connects it to core, storage and page, and opens the plant of the address. */
function startWith(model: PageModel, cores: CoreGrower, ui: UiState): Studio {
	cores.warm(model.wasm); // Models of a family share a core of another name.
	loadRenderer(model).catch(() => {}); // The stage tries again and reports the error.
	// A client drops all but the newest request: searches need a client of their own.
	const searching = new CoreGrower(coreAddress, new Client({ background: true }));
	const offscreen = new CoreGrower(coreAddress, new Client({ background: true }));
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
				if (next.language !== before.language) void reload(studio, bar);
			},
		},
	);
	// Request the growth before the parts are drawn; a text in the fragment has to be unpacked first.
	const recent = recentInAddress(location);
	if (recent !== undefined) void openLate(studio, readRecent(model, recent));
	else if (opened.whole) studio.open(opened, "link");
	else void openLate(studio, readWholeAddress(model, location));
	draw(studio);
	followFirst(studio, growing, startUpdater(studio));
	listenForSkips();
	followOtherTabs(studio);
	addEventListener("popstate", () => void follow(studio, bar));
	return studio;
}

/** Reads a recent plant, with the parts that the address cannot hold if they can be read. */
async function readRecent(model: PageModel, id: string): Promise<Restored> {
	const { search, hash } = location;
	const reader = await import("./recent/open_recent").catch(() => undefined);
	return reader ? reader.readRecentAddress(model, { search, hash }, id) : readWholeAddress(model, { search, hash });
}

/** Connects the page's elements, shortcuts, the system's theme and the tab's title to the studio. */
function draw(studio: Studio): void {
	for (const part of document.querySelectorAll<StudioPart>(PARTS)) part.context = studio;
	const help = () => void openPart(studio, HELP);
	document.addEventListener("panicle-help", help);
	listenForShortcuts(studio);
	onSystemTheme((dark) => studio.setSystemDark(dark));
	// Title, description and picture of the page are those of the plant.
	let named: readonly unknown[] | undefined;
	const describePlant = () => {
		const { model, specimen, modelUi, tools, dark } = studio.state;
		const shown = [model, modelUi, tools, ...allBut(specimen, runningBy(modelUi?.tools))];
		if (named && !changed(named, shown)) return;
		named = shown;
		const preset = model.presets.named(specimen.preset);
		describePage({
			title: text("tab_title", { title: titleOf(specimen, model, modelUi?.tools), seed: `${specimen.seed}` }),
			about: preset ? described(preset) : text("plant_about"),
			picture: preset && model.pictures !== false ? pictureOf(model, preset, dark) : undefined,
		});
	};
	describePlant();
	studio.subscribe(describePlant);
}

/** Loads the page again, in the chosen language, once the address holds the plant. */
async function reload({ state: { model, specimen } }: Studio, bar: AddressBar): Promise<void> {
	await bar.write(model, specimen);
	location.reload();
}

/**
 * Applies the theme and the keyboard setting that another tab has chosen; offers to reload in the language chosen
 * there.
 */
function followOtherTabs(studio: Studio): void {
	addEventListener("storage", ({ key }) => {
		if (key !== null && key !== STORAGE_KEY) return;
		const { language, ...shared } = pageOf(loadUi(localStorageOr()));
		studio.setUi(shared);
		if (language === studio.state.ui.language) return;
		const act = { label: text("reload"), run: () => location.reload() };
		studio.notify(text("language_changed"), [text("reload_advice")], { topic: "language", act });
	});
}

/** Stores the built app for offline use and offers new versions; not in development. */
function startUpdater(studio: Studio): AppUpdater | undefined {
	if (!import.meta.env.PROD) return undefined;
	const updater = new AppUpdater((reload) => {
		const act = { label: text("reload"), run: reload };
		studio.notify(text("update_available"), [text("reload_advice")], { topic: "version", act });
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

/**
 * After the first plant is drawn or has failed: replaces its sketch, fills the gallery with every model's presets,
 * starts the updater, and shows the first hints.
 */
function followFirst(studio: Studio, growing: PageGrowth, updater: AppUpdater | undefined): void {
	const end = studio.subscribe(async () => {
		const { shown, failure } = studio.state;
		if (!shown && !failure) return;
		end();
		if (shown) await firstDrawing();
		growing.finish();
		if (shown && hintsDue().length > 0) startHints();
		// Without it, the page records neither recent plants nor its undo history.
		import("./session/remember").then(({ remember }) => remember(studio)).catch(() => {});
		void Promise.allSettled(modelNames().map((name) => modelNamed(name))).then((models) => {
			studio.list(models.flatMap((model) => (model.status === "fulfilled" ? [model.value] : [])));
			updater?.start().catch(() => {}); // Then the app works online only.
		});
	});
}

/** Shows a new visitor the first hints; without their script, the page works without hints. */
function startHints(): void {
	HINTS.load().then(
		() => document.querySelector<Hints>(HINTS.tag)?.start(),
		() => {},
	);
}

let followed = 0;

/** Follows a change of the address by Back, Forward or typing. */
async function follow(studio: Studio, bar: AddressBar): Promise<void> {
	const turn = ++followed;
	const { search, hash } = location;
	// Back to the home page, from which the studio was started in place.
	if (!namesPlant(location)) return location.reload();
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
		studio.notify(text("link_failed"), fetchFailed());
	}
}
