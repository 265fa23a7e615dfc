import { boundaryHandles } from "../particles/boundary/editor/plant_handles";
import { rootLayout } from "./layout";

export const rootHandles = boundaryHandles(rootLayout);
