/** What the download menu offers besides files. */
import { copyPicture } from "../files/copy_picture";
import type { Studio } from "../studio";
import { TRY_AGAIN } from "../types";

export interface MenuAction {
	readonly key: string;
	readonly title: string;
	readonly about: string;
	/** @param menu where dialogs stand; the focus is back in it when they close */
	run(studio: Studio, menu: HTMLElement): Promise<void>;
}

/** Something that is opened: a part of the page, loaded when it is first asked for. */
interface Opened extends HTMLElement {
	open(): Promise<void>;
}

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

/** What there is now: pictures only while there is a view. */
export const menuActions = ({ state: { picture } }: Studio): readonly MenuAction[] =>
	picture ? [MANY, PICTURE, EMBED] : [MANY, EMBED];

function dialog(tag: string, load: () => Promise<unknown>, failed: string): MenuAction["run"] {
	return async function run(studio, menu) {
		try {
			await load();
		} catch {
			const again = () => void run(studio, menu);
			return studio.notify(failed, ["Part of the page could not be fetched.", TRY_AGAIN], { again });
		}
		try {
			await menu.querySelector<Opened>(tag)?.open();
		} catch (error) {
			studio.notify(failed, [error instanceof Error ? error.message : String(error)]);
		}
	};
}
