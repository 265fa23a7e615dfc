/** File types that the file picker offers, as the attribute `accept` has them. */
export const ACCEPT = ".glb,.json,.png,.lsys,.gl3,.growth,.stand,.xml,model/gltf-binary,application/json,image/png";
