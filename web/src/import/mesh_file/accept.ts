/** The files that the picker offers. */
export const ACCEPT = ".obj,.glb,.stl,model/obj,model/gltf-binary,model/stl";
