/** Actions of the download menu besides files. */
import { copyPicture } from "../files/copy_picture";
import type { Studio } from "../studio";
import { SAVED } from "./late_parts";
import { openPart } from "./open_part";

export interface MenuAction {
	readonly key: string;
	readonly title: string;
	readonly about: string;
	/** @param menu contains the dialogs; the focus returns to it when they close */
	run(studio: Studio, menu: HTMLElement): Promise<void>;
}

const SAVE: MenuAction = {
	key: "save",
	title: "Save in this browser…",
	about: "Under a name, with a picture; nothing is sent anywhere",
	run: (studio) => openPart(studio, SAVED),
};
const MANY: MenuAction = {
	key: "many",
	title: "Many in one ZIP…",
	about: "A series of seeds, with what you vary, and a table",
	run: dialog("panicle-many", () => import("./many_dialog"), "The series could not be asked for"),
};
const PICTURE: MenuAction = {
	key: "copy-picture",
	title: "Copy picture",
	about: "The 3-D view, to be pasted elsewhere",
	run: copyPicture,
};
const EMBED: MenuAction = {
	key: "embed",
	title: "Copy embed code…",
	about: "It lives in a page of your own: an element, a frame, or a GLB in model-viewer",
	run: dialog("panicle-embed", () => import("./embed_dialog"), "The code could not be shown"),
};

/** The available actions: pictures only while there is a 3-D view. */
export const menuActions = ({ state: { picture } }: Studio): readonly MenuAction[] =>
	picture ? [SAVE, MANY, PICTURE, EMBED] : [SAVE, MANY, EMBED];

function dialog(tag: string, load: () => Promise<unknown>, failed: string): MenuAction["run"] {
	return (studio, menu) => openPart(studio, { tag, load, failed }, menu);
}
