// All that draws the charts of the details, none of which a first visit shows.

import '../css/chart.css';

export { Chart } from '../plot/chart';
export { activeSetChart, residualChart } from './convergence';
export { SWEEP_T, sweepChart } from './sweep-chart';
