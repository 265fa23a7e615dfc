import { boundaryHandles } from "../particles/boundary/editor/plant_handles";
import { treeLayout } from "./layout";

export const treeHandles = boundaryHandles(treeLayout);
