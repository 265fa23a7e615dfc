/** The types of controls/, for the bunch. */
import type * as context from "../../../ui/editor_context";
import type * as tool from "../../../ui/tool";
import type { Grown } from "../grown";
import { procedureOf } from "../schema";
import type { BunchSpecimen } from "../specimen";

export type BunchContext = context.EditorContext<BunchSpecimen, Grown>;
export type BunchState = context.EditorState<BunchSpecimen, Grown>;
export type BunchTool<T = unknown> = tool.Tool<BunchSpecimen, Grown, T>;

/** Only a natural bunch ages and is thinned by hand. */
export const isNatural = (specimen: BunchSpecimen): boolean => procedureOf(specimen) === "natural";
export const isPaper = (specimen: BunchSpecimen): boolean => procedureOf(specimen) === "paper";
