/** Writes HTML code that embeds a plant in another page. Pure text functions, without access to the page. */
import { linkParts } from "../../specimen/link";

/** Panicle's own element, a frame, or a GLB in model-viewer. */
export const EMBED_FORMS = ["element", "frame", "model-viewer"] as const;
export type EmbedForm = (typeof EMBED_FORMS)[number];

/** Options that the user chooses. */
export interface EmbedChoice {
	readonly form: EmbedForm;
	/** CSS pixels. */
	readonly width: number;
	readonly height: number;
	/** Whether the plant turns by itself. */
	readonly autorotate: boolean;
	/** Whether the plant sways in the wind, unless the reader prefers reduced motion. */
	readonly wind: boolean;
	readonly controls: boolean;
	readonly handles: boolean;
	/** Whether the plant is loaded only when it is near the screen. */
	readonly lazy: boolean;
}

/** The plant to embed. */
export interface Embedded {
	/** Address of the folder with `panicle.js` and `embed.html`, ending in a slash. */
	readonly app: string;
	/** The link from its `?` on. */
	readonly link: string;
	/** Text alternative for the plant. */
	readonly description: string;
	/** Name of the GLB, in the folder of the page. */
	readonly file: string;
}

/** Greatest width and height, CSS pixels. */
export const LONGEST_SIDE = 4096;

/** Address of model-viewer's script, of a release that has been reviewed. */
export const MODEL_VIEWER = "https://cdn.jsdelivr.net/npm/@google/model-viewer@4.4.0/dist/model-viewer.min.js";

/** Returns the HTML to copy into a page. */
export function embedCode(of: Embedded, choice: EmbedChoice): string {
	return CODE[choice.form](of, choice);
}

/** Returns the address of the frame that shows the plant. */
export function frameAddress({ app, link }: Pick<Embedded, "app" | "link">, choice: Partial<EmbedChoice>): string {
	const { query, fragment } = linkParts(link);
	const parameters = BOOLEAN_KEYS.filter((key) => choice[key]).map((key) => `&${key}=`);
	return `${app}embed.html${query}${parameters.join("")}${fragment}`;
}

/** Boolean attributes of the element, and keys of the frame's address. */
const BOOLEAN_KEYS = ["autorotate", "wind", "controls", "handles"] as const;

const CODE: Readonly<Record<EmbedForm, (of: Embedded, choice: EmbedChoice) => string>> = {
	element: ({ app, link }, choice) => {
		const own = BOOLEAN_KEYS.filter((key) => choice[key]).map((key) => ` ${key}`);
		const attributes = `link="${escapeAttribute(link)}"${own.join("")}${lazyAttribute(choice)} style="${styleOf(choice)}"`;
		return `${scriptTag(`${app}panicle.js`)}\n<panicle-specimen ${attributes}></panicle-specimen>`;
	},
	frame: (of, choice) => {
		const { width, height } = choice;
		const attributes = `title="${escapeAttribute(of.description)}" src="${escapeAttribute(frameAddress(of, choice))}" width="${width}" height="${height}"`;
		return `<iframe ${attributes}${lazyAttribute(choice)} style="border: 0; max-width: 100%"></iframe>`;
	},
	"model-viewer": ({ description, file }, choice) => {
		const turning = choice.autorotate ? " auto-rotate" : "";
		const turned = choice.controls ? " camera-controls" : "";
		const attributes = `src="${escapeAttribute(encodeURI(file))}" alt="${escapeAttribute(description)}"${turned}${turning}${lazyAttribute(choice)} style="${styleOf(choice)}"`;
		return `${scriptTag(MODEL_VIEWER)}\n<model-viewer ${attributes}></model-viewer>`;
	},
};

/** Returns the HTML that loads a script. */
const scriptTag = (address: string) => `<script type="module" src="${escapeAttribute(address)}"></script>`;
/** Returns the attribute that delays loading until the plant is near the screen; empty without that choice. */
const lazyAttribute = (choice: EmbedChoice) => (choice.lazy ? ' loading="lazy"' : "");
/** Returns the CSS of the plant's size. */
const styleOf = ({ width, height }: EmbedChoice) =>
	`display: block; width: ${width}px; max-width: 100%; height: ${height}px`;

/** Escapes a text for use in an attribute's value. */
function escapeAttribute(text: string): string {
	return text.replaceAll("&", "&amp;").replaceAll('"', "&quot;").replaceAll("<", "&lt;");
}
