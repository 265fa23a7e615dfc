/** File types in the file picker. */
export const ACCEPT = ".obj,.glb,.stl,model/obj,model/gltf-binary,model/stl";
