/** The types of controls/, for the leaf. */
import type * as desk from "../../../ui/desk";
import type * as tool from "../../../ui/tool";
import type { Leaf } from "../grown";
import type { LeafSpecimen } from "../specimen";

export type LeafDesk = desk.Desk<LeafSpecimen, Leaf>;
export type LeafTool<T = unknown> = tool.Tool<LeafSpecimen, Leaf, T>;
