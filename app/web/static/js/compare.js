// Compare
import "./page.js";
