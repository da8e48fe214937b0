// Study
import "./page.js";
