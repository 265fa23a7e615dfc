/** Types of tools and their context, for the bunch. */
import type * as context from "../../../ui/editor_context";
import type * as tool from "../../../ui/tool";
import type { BunchPlant } from "../bunch_plant";
import { procedureOf } from "../schema";
import type { BunchSpecimen } from "../specimen";

export type BunchContext = context.EditorContext<BunchSpecimen, BunchPlant>;
export type BunchState = context.EditorState<BunchSpecimen, BunchPlant>;
export type BunchTool<T = unknown> = tool.Tool<BunchSpecimen, BunchPlant, T>;

/** Returns whether a bunch is natural; only those age and are thinned by hand. */
export const isNatural = (specimen: BunchSpecimen): boolean => procedureOf(specimen) === "natural";
export const isPaper = (specimen: BunchSpecimen): boolean => procedureOf(specimen) === "paper";
