import { boundaryHandles } from "../particles/boundary/editor/plant_handles";
import { rootLay } from "./lay";

export const rootHandles = boundaryHandles(rootLay);
