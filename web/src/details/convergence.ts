import type { NewtonStep } from 'abflat';
import type { ChartSpec, Column, Series } from '../plot/chart-spec';
import { fixedScale, linearScale, logScale, type Scale } from '../plot/scale';
import { count, measure } from '../words/format';
import { CONVERGENCE } from '../words/plots';

/** Residuals by step, on a logarithmic scale as both go to 0. */
export function residualChart(history: NewtonStep[]): ChartSpec {
  const series = [
    line(CONVERGENCE.constraint, 'first', history, (step) => step.constraint),
    line(CONVERGENCE.gradient, 'second', history, (step) => step.gradient),
  ];
  return {
    title: CONVERGENCE.residual,
    description: CONVERGENCE.aboutResidual,
    xName: '',
    x: stepScale(history.length),
    y: logScale(
      series.flatMap(({ marks }) => marks.map(({ y }) => y)),
      5,
    ),
    series,
    columns: columns(history),
    table: {
      head: [CONVERGENCE.step, CONVERGENCE.constraintResidual, CONVERGENCE.gradientResidual],
      rows: history.map((s, i) => [String(i + 1), measure(s.constraint), measure(s.gradient)]),
    },
  };
}

/**
 * How many boundary vertices, and with the Delaunay condition how many interior edges, are held at
 * their bound in each step.
 */
export function activeSetChart(history: NewtonStep[]): ChartSpec {
  const series = [line(CONVERGENCE.vertices, 'first', history, ({ active }) => active)];
  if (history.some(({ activeEdges }) => activeEdges > 0))
    series.push(line(CONVERGENCE.edges, 'second', history, ({ activeEdges }) => activeEdges));
  const values = series.map(({ marks }) => marks.map(({ y }) => y));
  const most = values.flat().reduce((high, value) => Math.max(high, value), 2);
  return {
    title: CONVERGENCE.activeSet,
    description: CONVERGENCE.aboutActiveSet,
    xName: CONVERGENCE.step,
    x: stepScale(history.length),
    y: linearScale(most, 2),
    series,
    columns: columns(history),
    table: {
      head: [CONVERGENCE.step, ...series.map(({ name }) => name)],
      rows: history.map((_, i) => [String(i + 1), ...values.map((each) => count(each[i]))]),
    },
  };
}

function line(
  name: string,
  color: Series['color'],
  history: NewtonStep[],
  value: (step: NewtonStep) => number,
): Series {
  const marks = history.map((step, i) => ({ x: i + 1, y: value(step) }));
  return { name, color, shape: 'filled', hasLine: true, marks };
}

function columns(history: NewtonStep[]): Column[] {
  return history.map(({ constraint, gradient, active, activeEdges }, i) => ({
    x: i + 1,
    text: CONVERGENCE.atStep(i + 1, constraint, gradient, active, activeEdges),
  }));
}

/** Labels at most about ten steps. */
function stepScale(steps: number): Scale {
  const stride = Math.ceil(steps / 10);
  const named = Array.from({ length: steps }, (_, i) => i + 1).filter(
    (n) => (n - 1) % stride === 0,
  );
  const ticks = named.map((value) => ({ value, text: String(value) }));
  // A single step lies in the middle.
  return steps > 1 ? fixedScale(1, steps, ticks) : fixedScale(0, 2, ticks);
}
