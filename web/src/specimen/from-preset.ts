export * from "./from_preset";
