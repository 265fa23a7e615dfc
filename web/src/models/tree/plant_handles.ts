import { boundaryHandles } from "../particles/boundary/editor/plant_handles";
import { treeLay } from "./lay";

export const treeHandles = boundaryHandles(treeLay);
