import { EditorElement } from "../../ui/editor_element";
import type { Studio } from "../studio";

/** A part of the page with access to the studio's whole state; controls have an EditorContext only. */
export abstract class StudioPart extends EditorElement<Studio> {}
