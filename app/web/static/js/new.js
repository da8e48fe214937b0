// New study
import "./page.js";
