/** Code that puts a plant in somebody's page. Text in, text out: nothing of the page is looked at. */
import { linkParts } from "../../specimen/link";

/** By a script of ours, in a frame, or as a file in a viewer of others. */
export const EMBED_FORMS = ["element", "frame", "model-viewer"] as const;
export type EmbedForm = (typeof EMBED_FORMS)[number];

/** What a person chooses. */
export interface EmbedChoice {
	readonly form: EmbedForm;
	/** CSS pixels. */
	readonly width: number;
	readonly height: number;
	/** Whether it turns by itself. */
	readonly autorotate: boolean;
	/** Whether it sways in the wind, where readers wish for no less motion. */
	readonly wind: boolean;
	readonly controls: boolean;
	readonly handles: boolean;
	/** Whether it waits until it is near the screen. */
	readonly lazy: boolean;
}

/** What is to be put there. */
export interface Embedded {
	/** The folder that holds `panicle.js` and `embed.html`; an address with its last slash. */
	readonly app: string;
	/** From its `?` on. */
	readonly link: string;
	/** What it is, for those who do not see it. */
	readonly words: string;
	/** Of the GLB, which lies beside the page. */
	readonly file: string;
}

/** Most of what is asked of a side, CSS pixels. */
export const LONGEST_SIDE = 4096;

/** The viewer that model-viewer's own pages name, of a release that was looked at. */
export const MODEL_VIEWER = "https://cdn.jsdelivr.net/npm/@google/model-viewer@4.4.0/dist/model-viewer.min.js";

/** HTML to be copied into a page. */
export function embedCode(of: Embedded, choice: EmbedChoice): string {
	return CODE[choice.form](of, choice);
}

/** The address of a frame with the plant. */
export function frameAddress({ app, link }: Pick<Embedded, "app" | "link">, choice: Partial<EmbedChoice>): string {
	const { query, fragment } = linkParts(link);
	const own = OWN.filter((key) => choice[key]).map((key) => `&${key}=`);
	return `${app}embed.html${query}${own.join("")}${fragment}`;
}

/** Attributes of the element, and keys of the frame's address, that are there or not. */
const OWN = ["autorotate", "wind", "controls", "handles"] as const;

const CODE: Readonly<Record<EmbedForm, (of: Embedded, choice: EmbedChoice) => string>> = {
	element: ({ app, link }, choice) => {
		const own = OWN.filter((key) => choice[key]).map((key) => ` ${key}`);
		const attributes = `link="${escaped(link)}"${own.join("")}${lazy(choice)} style="${sized(choice)}"`;
		return `${script(`${app}panicle.js`)}\n<panicle-specimen ${attributes}></panicle-specimen>`;
	},
	frame: (of, choice) => {
		const { width, height } = choice;
		const attributes = `title="${escaped(of.words)}" src="${escaped(frameAddress(of, choice))}" width="${width}" height="${height}"`;
		return `<iframe ${attributes}${lazy(choice)} style="border: 0; max-width: 100%"></iframe>`;
	},
	"model-viewer": ({ words, file }, choice) => {
		const turning = choice.autorotate ? " auto-rotate" : "";
		const turned = choice.controls ? " camera-controls" : "";
		const attributes = `src="${escaped(encodeURI(file))}" alt="${escaped(words)}"${turned}${turning}${lazy(choice)} style="${sized(choice)}"`;
		return `${script(MODEL_VIEWER)}\n<model-viewer ${attributes}></model-viewer>`;
	},
};

const script = (address: string) => `<script type="module" src="${escaped(address)}"></script>`;
const lazy = (choice: EmbedChoice) => (choice.lazy ? ' loading="lazy"' : "");
const sized = ({ width, height }: EmbedChoice) =>
	`display: block; width: ${width}px; max-width: 100%; height: ${height}px`;

function escaped(text: string): string {
	return text.replaceAll("&", "&amp;").replaceAll('"', "&quot;").replaceAll("<", "&lt;");
}
