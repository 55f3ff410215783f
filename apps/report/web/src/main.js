import { showFlight } from './flight.js';
import { showComparison } from './comparison.js';
import { resizeAllForPrint } from './charts.js';

const data = JSON.parse(document.getElementById('report-data').textContent);
const show = { flight: showFlight, comparison: showComparison }[data.kind];
show(document.getElementById('report'), data);
resizeAllForPrint();
document.documentElement.dataset.ready = 'true';
