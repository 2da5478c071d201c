// Classical systems that are not in the catalog: text, parameters, ε, first points, axes.
const CLASSICAL = [
  { name: 'The Lotka–Volterra equations', field: 'xdot = x*(1 - y);\nydot = y*(x - 1);', eps: '0.1', at: ['1,1/2', '1,1/4', '1,1/8'], steps: 4000 },
  { name: 'A rigid body', field: 'xdot = (1/I2 - 1/I3)*y*z;\nydot = (1/I3 - 1/I1)*z*x;\nzdot = (1/I1 - 1/I2)*x*y;', params: { I1: '1', I2: '2', I3: '3' }, eps: '0.1', at: ['1,1/10,1', '1/10,1,1/10', '1,1/10,1/3'], steps: 4000 },
  { name: 'Lorenz’ butterfly', field: 'xdot = s*(y - x);\nydot = x*(r - z) - y;\nzdot = x*y - b*z;', params: { s: '10', r: '28', b: '8/3' }, eps: '0.005', at: ['1,1,20'], steps: 20000, axes: ['x', 'z'] },
  { name: 'Rössler’s band', field: 'xdot = -y - z;\nydot = x + a*y;\nzdot = b + z*(x - c);', params: { a: '1/5', b: '1/5', c: '57/10' }, eps: '0.01', at: ['1,1,0'], steps: 20000 },
  { name: 'Hénon and Heiles', field: 'xdot = p;\nydot = q;\npdot = -x - 2*x*y;\nqdot = -y - x^2 + y^2;', eps: '0.05', at: ['1/10,1/5,3/10,0'], steps: 20000 },
  { name: 'May and Leonard’s competition', field: 'xdot = x*(1 - x - a*y - b*z);\nydot = y*(1 - b*x - y - a*z);\nzdot = z*(1 - a*x - b*y - z);', params: { a: '4/5', b: '6/5' }, eps: '0.05', at: ['1/2,1/5,1/10', '1/4,1/4,1/3'], steps: 10000 },
  { name: 'Three species that eat in a ring', field: 'xdot = x*(y - z);\nydot = y*(z - x);\nzdot = z*(x - y);', eps: '0.05', at: ['1,1/2,1/3', '1,4/5,2/3', '1,1/4,1/8'], steps: 4000 },
  { name: 'The Volterra lattice of five sites', field: 'x1dot = x1*(x2 - x5);\nx2dot = x2*(x3 - x1);\nx3dot = x3*(x4 - x2);\nx4dot = x4*(x5 - x3);\nx5dot = x5*(x1 - x4);', eps: '0.05', at: ['1,2/3,1/2,1,3/4'], steps: 10000, axes: ['x1', 'x3'] },
  { name: 'Suslov’s problem', field: 'xdot = y*(a*x + b*y);\nydot = -x*(a*x + b*y);', params: { a: '1', b: '1/2' }, eps: '0.05', at: ['1,-1', '1/2,-1/2', '-1,1/5'], steps: 1000 },
  { name: 'Nambu’s top', field: 'xdot = y*z;\nydot = -2*z*x;\nzdot = x*y;', eps: '0.1', at: ['1,1/5,1', '1,1,1', '1/5,1,1/2'], steps: 4000 },
]
