import { EditorElement } from "../../ui/editor_element";
import type { Studio } from "../studio";

/** A part of the page that draws the whole studio's state, not only what a control has of it. */
export abstract class StudioPart extends EditorElement<Studio> {}
