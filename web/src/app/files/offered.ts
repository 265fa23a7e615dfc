/** Modules of the download menu, fetched when it is opened for the first time. */

export { NotFetched } from "../../generate/files/exporter";
export { saveFile } from "../../ui/save_file";
export { fileSettings } from "../parts/file_settings";
export { menuActions } from "../parts/menu_actions";
export { downloadFormats, fileName } from "./formats";
export { downloadRequestFor, MadeAhead, sizeInWords } from "./made_ahead";
export { plantToSave } from "./plant_to_save";
