import { linear } from "../../../plant/colour";
import type { Material } from "../../../plant/material";

/** Moving particles: small bright spheres. */
export const particleMaterial: Material = { name: "Particle", colour: linear("e0a63c"), roughness: 0.4 };
