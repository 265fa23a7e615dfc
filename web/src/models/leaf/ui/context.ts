/** Types of the editor for leaves. */
import type * as context from "../../../ui/editor_context";
import type * as tool from "../../../ui/tool";
import type { Leaf } from "../grown";
import type { LeafSpecimen } from "../specimen";

export type LeafContext = context.EditorContext<LeafSpecimen, Leaf>;
export type LeafTool<T = unknown> = tool.Tool<LeafSpecimen, Leaf, T>;
