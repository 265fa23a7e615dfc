/** The application with one model more: what a page does that brings its own. */
import wasm from "../../build/core-test/toy.wasm?url";
import { addModel } from "../../web/src/models/index";

addModel("toy", async () => ({ ...(await import("./index")).model, wasm: new URL(wasm, document.baseURI).href }));
await import("../../web/src/app/main");
