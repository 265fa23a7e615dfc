/** The files that the picker offers. */
export const ACCEPT = ".obj,.glb,model/obj,model/gltf-binary";
