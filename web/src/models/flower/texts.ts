import { presetTexts } from "../../specimen/preset_texts";
import { PRESETS } from "./presets.generated";

export const { fetchTexts, fetchedText } = presetTexts(PRESETS, () => import("./texts.generated"));
