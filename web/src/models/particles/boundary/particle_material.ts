import { linear } from "../../../plant/colour";
import type { Material } from "../../../plant/material";

/** Particles on their way: small bright balls. */
export const particleMaterial: Material = { name: "Particle", colour: linear("e0a63c"), roughness: 0.4 };
