/** Entry of the page: shows the home page where the address names no plant, and the studio with the plant otherwise. */
import { namesPlant } from "./address_plant";
import { startLanguage } from "./language";
import { localStorageOr } from "./local_storage";
import { refuse } from "./refuse";
import { applyTheme } from "./theme";
import { loadUi } from "./ui_state";

const ui = loadUi(localStorageOr());
applyTheme(ui.theme);
const language = startLanguage(ui.language);
const shown = namesPlant(location) ? import("./start_studio") : import("./home/home_page");
shown.then(({ start }) => start(ui, language), refuse);
