/**
 * Tools to design a flower: fields of six organs in the panel, and flat views with handles. All changes are written
 * into the text.
 */
import { html, nothing } from "lit";
import { fromPreset } from "../../../../specimen/from_preset";
import { isPicture } from "../../../../ui/picture_file";
import { saveFile } from "../../../../ui/save_file";
import type { Tool } from "../../../../ui/tool";
import type { Description } from "../../design/description";
import { assembled } from "../../design/design";
import { designedNear } from "../../design/near";
import { ORGANS, type Organ } from "../../design/organs";
import type { FlowerPlant } from "../../flower_plant";
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
	title: "Design",
	help: "The flower organ by organ. Choices write its grammar.",
	everyday: true,
	plain: true,
} as const;

const isDesigned = (specimen: FlowerSpecimen): boolean => designIn(specimen) !== undefined;

/** Shown where a text describes no organs. */
export const beginTool: DesignTool = {
	name: "begin-design",
	initial: undefined,
	applies: (specimen) => !isDesigned(specimen),
	panel: {
		group: GROUP,
		place: "above",
		draw: (context) => {
			const near = designedNear(context.state.specimen.preset);
			const title = FLOWER.presets.named(near)?.title;
			return html`<p>This flower’s text has no descriptions of its organs: it is edited as a grammar. Another flower that has them, or a new one:</p>
			<div class="actions">
				<button class="button" type="button" @click=${() => context.replace(fromPreset(FLOWER, near))}>Open ${title}</button>
				<button class="button" type="button" @click=${() => context.set(textChange(context.state.specimen, assembled()))}>
					Design a new flower
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
					<button class="button" type="button" @click=${() => saveScene(context, "diagram", floralDiagram)}>Diagram as SVG</button>
					<button class="button" type="button" @click=${() => saveScene(context, "elevation", elevation)}>Elevation as SVG</button>
				</div>`,
	},
	keys: [
		{
			keys: ["Arrow keys"],
			does: "On a handle of a diagram, an elevation or an outline: more, less; Shift goes farther",
		},
		{ keys: ["Page ↑", "Page ↓"], does: "On such a handle: the one before, the next" },
	],
	drop: {
		words: "a picture of a petal is traced",
		takes: isPicture,
		take: (context, file) => void traceInto(context, drafts, bladed(context.toolState(designTool)), file),
	},
};

function view(
	name: string,
	title: string,
	of: (descriptions: readonly Description[], chosen: Organ) => Scene,
): DesignTool {
	return {
		name,
		initial: undefined,
		applies: isDesigned,
		editor: { title, draw: (context) => draw(context, title, of) },
	};
}

function draw(
	context: FlowerContext,
	title: string,
	of: (descriptions: readonly Description[], chosen: Organ) => Scene,
): unknown {
	const design = designIn(context.state.specimen);
	if (!design) return nothing;
	const chosen = context.toolState(designTool);
	return html`<panicle-flower-design
		heading=${title} .descriptions=${descriptionsIn(design)} .of=${(descriptions: readonly Description[]) => of(descriptions, chosen)}
		@design-input=${({ detail: { descriptions, run } }: DesignEvent) => drafts.edit(context, descriptions, run)}
		@design-change=${() => drafts.settle(context)} @design-focus=${({ detail }: CustomEvent<string>) => meant(context, detail)}
	></panicle-flower-design>`;
}

/** Saves a flat view as a file, without a selected organ. */
function saveScene(context: FlowerContext, name: string, of: (descriptions: readonly Description[]) => Scene): void {
	const { specimen } = context.state;
	const design = designIn(specimen);
	if (!design) return;
	const title = `${FLOWER.presets.named(specimen.preset)?.title ?? "Flower"}, ${name}`;
	const picture = pictureOf(of(descriptionsIn(design)), title);
	saveFile(new Blob([picture], { type: "image/svg+xml" }), `${specimen.preset}-${name}.svg`);
}

/** Selects the organ whose handle gets the focus. */
function meant(context: FlowerContext, handle: string): void {
	const organ = ORGANS.find((each) => handle.startsWith(`${each}-`));
	if (organ && organ !== context.toolState(designTool)) context.setToolState(designTool, organ);
}

/** Returns the organ whose outline is shown; stems, stamens and pistils have none. */
const bladed = (chosen: Organ): Organ => (chosen === "leaf" || chosen === "sepal" ? chosen : "petal");

export const designTools: readonly DesignTool[] = [
	designTool as DesignTool,
	view("diagram", "Diagram", floralDiagram),
	view("elevation", "Elevation", elevation),
	view("outline", "Outline", (descriptions, chosen) =>
		outlineScene(descriptions.find(({ organ }) => organ === bladed(chosen)) as Description),
	),
];
