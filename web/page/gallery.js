// Classical systems that are not in the catalog: text, parameters, ε, first points, axes. The page
// opens with the first; the last are not quadratic.
const CLASSICAL = [
  { name: 'Helmholtz’ oscillator, a spring softer on one side', field: 'xdot = v;\nvdot = -x - x^2;', eps: '0.15', at: ['1/10,0', '1/5,0', '3/10,0', '2/5,0', '12/25,0'], steps: 1000 },
  { name: 'The Volterra lattice of five sites', field: 'x1dot = x1*(x2 - x5);\nx2dot = x2*(x3 - x1);\nx3dot = x3*(x4 - x2);\nx4dot = x4*(x5 - x3);\nx5dot = x5*(x1 - x4);', eps: '0.05', at: ['1,2/3,1/2,1,3/4'], steps: 10000, axes: ['x1', 'x3'] },
  { name: 'Toda’s lattice of three sites', field: 'a1dot = a1*(b2 - b1);\na2dot = a2*(b3 - b2);\na3dot = a3*(b1 - b3);\nb1dot = 2*(a1^2 - a3^2);\nb2dot = 2*(a2^2 - a1^2);\nb3dot = 2*(a3^2 - a2^2);', eps: '0.02', at: ['1/2,2/3,1/3,1/5,0,-1/5'], steps: 10000, axes: ['a1', 'b1'] },
  { name: 'Suslov’s problem', field: 'xdot = y*(a*x + b*y);\nydot = -x*(a*x + b*y);', params: { a: '1', b: '1/2' }, eps: '0.05', at: ['1,-1', '1/2,-1/2', '-1,1/5'], steps: 1000 },
  { name: 'Darboux’ and Halphen’s system', field: 'xdot = y*z - x*(y + z);\nydot = z*x - y*(z + x);\nzdot = x*y - z*(x + y);', eps: '0.005', at: ['1,2,-1/2', '1,2,-1/4', '1,2,-1/8'], steps: 1000 },
  { name: 'Kermack and McKendrick’s epidemic', field: 'sdot = -b*s*i;\nidot = b*s*i - g*i;', params: { b: '1/2', g: '1/5' }, eps: '0.05', at: ['99/100,1/100', '4/5,1/100', '3/5,1/100'], steps: 2000 },
  { name: 'Nosé and Hoover’s oscillator', field: 'xdot = y;\nydot = -x - y*z;\nzdot = y^2 - 1;', eps: '0.02', at: ['0,5,0', '0,1,0', '0,3/2,0'], steps: 20000, axes: ['x', 'z'] },
  { name: 'May and Leonard’s competition', field: 'xdot = x*(1 - x - a*y - b*z);\nydot = y*(1 - b*x - y - a*z);\nzdot = z*(1 - a*x - b*y - z);', params: { a: '4/5', b: '6/5' }, eps: '0.05', at: ['1/2,1/5,1/10', '1/4,1/4,1/3'], steps: 10000 },
  { name: 'Rössler’s band', field: 'xdot = -y - z;\nydot = x + a*y;\nzdot = b + z*(x - c);', params: { a: '1/5', b: '1/5', c: '57/10' }, eps: '0.01', at: ['1,1,0'], steps: 20000 },
  { name: 'Rikitake’s dynamo', field: 'xdot = -m*x + z*y;\nydot = -m*y + (z - a)*x;\nzdot = 1 - x*y;', params: { m: '1', a: '15/4' }, eps: '0.01', at: ['1,1,2'], steps: 20000, axes: ['x', 'z'] },
  { name: 'The pendulum, lifted', field: 'xdot = v;\nvdot = -sin(x);', lift: 'automatic', eps: '0.1', at: ['1/2,0', '3/2,0', '5/2,0', '-4,2'], steps: 1000 },
  { name: 'Kepler’s problem, lifted', field: 'xdot = u;\nydot = v;\nudot = -x/(x^2 + y^2)^(3/2);\nvdot = -y/(x^2 + y^2)^(3/2);', lift: 'automatic', eps: '0.02', at: ['1,0,0,11/10'], steps: 2000 },
  { name: 'FitzHugh and Nagumo’s neuron, lifted', field: 'vdot = v - v^3/3 - w + i;\nwdot = (v + 7/10 - 4/5*w)*2/25;', lift: 'automatic', params: { i: '1/2' }, eps: '0.02', at: ['1,0', '-1,1'], steps: 5000 },
]
