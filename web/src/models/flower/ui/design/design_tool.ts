/**
 * Tools to design a flower: fields of six organs in the panel, and flat views with handles. All changes are written
 * into the text.
 */

import { html, nothing } from "lit";
import { fromPreset } from "../../../../specimen/from_preset";
import { isPicture } from "../../../../ui/picture_file";
import { saveFile } from "../../../../ui/save_file";
import { BASICS, type Tool } from "../../../../ui/tool";
import type { Description } from "../../design/description";
import { assembled } from "../../design/design";
import { designedNear } from "../../design/near";
import { ORGANS, type Organ } from "../../design/organs";
import type { FlowerPlant } from "../../flower_plant";
import { text } from "../../messages.generated";
import { FLOWER } from "../../schema";
import type { FlowerSpecimen } from "../../specimen";
import type { DesignEvent } from "./design_view";
import { Drafts, descriptionsIn, designIn, type FlowerContext, textChange } from "./drafts";
import { elevation } from "./elevation";
import { floralDiagram } from "./floral_diagram";
import { outlineScene } from "./outline_scene";
import { pictureOf, type Scene } from "./scene";
import { traceInto } from "./trace";
import "./design_panel";
import "./design_view";

type DesignTool<T = unknown> = Tool<FlowerSpecimen, FlowerPlant, T>;

const drafts = new Drafts();

const GROUP = {
	key: "design",
	get title() {
		return text("design");
	},
	get help() {
		return text("design_help");
	},
	plain: true,
} as const;

/** Returns whether a flower's text describes its organs. */
export const isDesigned = (specimen: FlowerSpecimen): boolean => designIn(specimen) !== undefined;

/** Shown where a text describes no organs. */
export const beginTool: DesignTool = {
	name: "begin-design",
	initial: undefined,
	applies: (specimen) => !isDesigned(specimen),
	panel: {
		group: GROUP,
		place: "above",
		/** Renders buttons for flowers whose text has no design: open a similar designed preset, or begin a new design. */
		draw: (context) => {
			const near = designedNear(context.state.specimen.preset);
			const title = FLOWER.presets.named(near)?.title;
			return html`<p>${text("not_described")}</p>
			<div class="actions">
				<button class="button" type="button" @click=${() => context.replace(fromPreset(FLOWER, near))}>${text("open_preset", { title: title ?? "" })}</button>
				<button class="button" type="button" @click=${() => context.set(textChange(context.state.specimen, assembled()))}>
					${text("design_new")}
				</button>
			</div>`;
		},
	},
};

/** Tool state: the selected organ. */
export const designTool: DesignTool<Organ> = {
	name: "design",
	initial: "petal",
	applies: isDesigned,
	panel: {
		group: GROUP,
		place: "above",
		draw: (context) =>
			html`<panicle-flower-organs .context=${context} .tool=${designTool} .drafts=${drafts}></panicle-flower-organs>
				<div class="actions">
					<button class="button" type="button" @click=${() => saveScene(context, "diagram", floralDiagram)}>${text("diagram_svg")}</button>
					<button class="button" type="button" @click=${() => saveScene(context, "elevation", elevation)}>${text("elevation_svg")}</button>
				</div>`,
	},
	keys: [
		{
			get keys() {
				return [text("arrow_keys")];
			},
			get description() {
				return text("key_arrows");
			},
		},
		{
			keys: ["Page ↑", "Page ↓"],
			get description() {
				return text("key_page");
			},
		},
	],
	drop: {
		get description() {
			return text("trace_drop");
		},
		takes: isPicture,
		take: (context, file) => void traceInto(context, drafts, outlinedOrgan(context.toolState(designTool)), file),
	},
};

/**
 * Creates a tool whose editor is a flat view.
 * @param sceneOf returns the scene of a design
 */
function view(
	name: "diagram" | "elevation" | "outline",
	sceneOf: (descriptions: readonly Description[], chosen: Organ) => Scene,
): DesignTool {
	return {
		name,
		initial: undefined,
		applies: isDesigned,
		editor: {
			get title() {
				return text(name);
			},
			draw: (context) => draw(context, text(name), sceneOf),
		},
	};
}

/** Renders the view for the design in the text; its changes are written into the text as drafts until the drag ends. */
function draw(
	context: FlowerContext,
	title: string,
	sceneOf: (descriptions: readonly Description[], chosen: Organ) => Scene,
): unknown {
	const design = designIn(context.state.specimen);
	if (!design) return nothing;
	const chosen = context.toolState(designTool);
	return html`<panicle-flower-design
		heading=${title} .descriptions=${descriptionsIn(design)} .of=${(descriptions: readonly Description[]) => sceneOf(descriptions, chosen)}
		@design-input=${({ detail: { descriptions, run } }: DesignEvent) => drafts.edit(context, descriptions, run)}
		@design-change=${() => drafts.settle(context)} @design-focus=${({ detail }: CustomEvent<string>) => selectOrganOf(context, detail)}
	></panicle-flower-design>`;
}

/** Saves a flat view as a file, without a selected organ. */
function saveScene(
	context: FlowerContext,
	name: "diagram" | "elevation",
	sceneOf: (descriptions: readonly Description[]) => Scene,
): void {
	const { specimen } = context.state;
	const design = designIn(specimen);
	if (!design) return;
	const title = text(`${name}_title`, { flower: FLOWER.presets.named(specimen.preset)?.title ?? text("title") });
	const picture = pictureOf(sceneOf(descriptionsIn(design)), title);
	saveFile(new Blob([picture], { type: "image/svg+xml" }), `${specimen.preset}-${name}.svg`);
}

/** Selects the organ whose handle gets the focus. */
function selectOrganOf(context: FlowerContext, handle: string): void {
	const organ = ORGANS.find((each) => handle.startsWith(`${each}-`));
	if (organ && organ !== context.toolState(designTool)) context.setToolState(designTool, organ);
}

/** Returns the organ whose outline is shown; stems, stamens and pistils have none. */
const outlinedOrgan = (chosen: Organ): Organ => (chosen === "leaf" || chosen === "sepal" ? chosen : "petal");

/** The basics of a designed flower. */
const basicDesign: DesignTool = {
	name: "basic-design",
	initial: undefined,
	applies: isDesigned,
	panel: {
		group: BASICS,
		place: "above",
		draw: (context) =>
			html`<panicle-flower-organs .context=${context} .tool=${designTool} .drafts=${drafts} .basics=${true}></panicle-flower-organs>`,
	},
};

export const designTools: readonly DesignTool[] = [
	basicDesign,
	designTool as DesignTool,
	view("diagram", floralDiagram),
	view("elevation", elevation),
	view("outline", (descriptions, chosen) =>
		outlineScene(descriptions.find(({ organ }) => organ === outlinedOrgan(chosen)) as Description),
	),
];
