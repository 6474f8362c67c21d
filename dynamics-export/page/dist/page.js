/*! This script holds the following works.

three 0.187.0

The MIT License

Copyright © 2010-2026 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.

uplot 1.6.32

The MIT License (MIT)

Copyright (c) 2022 Leon Sorokin

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.
*/
var Mx=Object.defineProperty;var bx=(n,e,t)=>e in n?Mx(n,e,{enumerable:!0,configurable:!0,writable:!0,value:t}):n[e]=t;var vp=(n,e,t)=>bx(n,typeof e!="symbol"?e+"":e,t);function W(n,e={},...t){let i=document.createElement(n);for(let[s,r]of Object.entries(e))s.startsWith("on")?i.addEventListener(s.slice(2),r):s==="class"?i.className=r:s.includes("-")||!(s in i)?i.setAttribute(s,r):i[s]=r;return i.append(...t.flat(1/0).filter(s=>s!=null)),i}function fn(n,e){let t=W("i",{},n);return e===null?[t]:[t,W("sub",{},String(e))]}function Sp(n){return W("data",{"data-key":n})}function Mp(n,e,t){n.value=String(e),n.title=String(e),n.textContent=t}var Mu=180/Math.PI;function pr(n){if(Number.isNaN(n))return"\u2013";if(!Number.isFinite(n))return String(n);let e=Math.abs(n);if(e<5e-13)return"0";if(e<.001||e>=1e6)return n.toExponential(2);let t=e<10?4:e<100?3:e<1e3?2:1;return n.toFixed(t)}function mt(n,e=4){return String(Number(n.toPrecision(e)))}function wx(n){for(let e of[1,2,3,4,6,12]){let t=n/Math.PI*e,i=Math.round(t);if(i===0||Math.abs(t-i)>1e-9)continue;let s=i<0?"-":"",r=Math.abs(i)===1?"":String(Math.abs(i));return`${s}${r}\u03C0${e===1?"":`/${e}`}`}return null}function bu(n){let e=n?"\xB0":"rad";return{inDegrees:n,angleUnit:e,factor:i=>i==="revolute"&&n?Mu:1,position:i=>i==="revolute"?e:"m",velocity:i=>i==="revolute"?`${e}/s`:"m/s",acceleration:i=>i==="revolute"?`${e}/s\xB2`:"m/s\xB2",force:i=>i==="revolute"?"N m":"N",angle:i=>n?`${mt(i*Mu)}\xB0`:`${mt(i)} rad`,length:i=>`${mt(i)} m`,number:i=>Math.abs(i)<1e-12?"0":mt(i),cell:i=>n?mt(i*Mu,6):wx(i)??mt(i,6)}}var Oe=(n,e)=>[n[0]+e[0],n[1]+e[1],n[2]+e[2]],At=(n,e)=>[n[0]-e[0],n[1]-e[1],n[2]-e[2]],be=(n,e)=>[e*n[0],e*n[1],e*n[2]],hi=(n,e)=>n[0]*e[0]+n[1]*e[1]+n[2]*e[2],Ot=n=>Math.hypot(n[0],n[1],n[2]),Qi=(n,e)=>Ot(At(n,e)),pn=(n,e)=>[n[1]*e[2]-n[2]*e[1],n[2]*e[0]-n[0]*e[2],n[0]*e[1]-n[1]*e[0]],On=n=>be(n,1/(Ot(n)||1));function mr(n,e,t){let[i,s]=[Math.sin(t),Math.cos(t)],r=be(e,hi(e,n)*(1-s));return Oe(Oe(be(n,s),be(pn(e,n),i)),r)}var zs={x:[1,0,0],y:[0,1,0],z:[0,0,1],o:[0,0,0]};function ks(n,e){return Oe(Oe(be(n.x,e[0]),be(n.y,e[1])),be(n.z,e[2]))}function gr(n,e){return Oe(n.o,ks(n,e))}function wu({x:n,y:e,z:t,o:i},s,r){let[o,a]=[Math.sin(r),Math.cos(r)];return{x:Oe(be(n,a),be(e,o)),y:At(be(e,a),be(n,o)),z:t,o:Oe(i,be(t,s))}}function Eu({x:n,y:e,z:t,o:i},s,r){let[o,a]=[Math.sin(r),Math.cos(r)];return{x:n,y:Oe(be(e,a),be(t,o)),z:At(be(t,a),be(e,o)),o:Oe(i,be(n,s))}}function es(n,{xyz:e,rpy:t}){let[i,s,r]=t.map(Math.sin),[o,a,l]=t.map(Math.cos);return{x:ks(n,[l*a,r*a,-s]),y:ks(n,[l*s*i-r*o,r*s*i+l*o,a*i]),z:ks(n,[l*s*o+r*i,r*s*o-l*i,a*o]),o:gr(n,e)}}function Qr(n){let e=Math.atan2(-n[2][0],Math.hypot(n[0][0],n[1][0]));return Math.hypot(n[0][0],n[1][0])<1e-9?[0,e,Math.atan2(-n[0][1],n[1][1])]:[Math.atan2(n[2][1],n[2][2]),e,Math.atan2(n[1][0],n[0][0])]}function bp(n){if(n.length===1)return n[0];let{x:e,y:t,z:i,o:s}=n.reduce(es,zs),r=Qr([0,1,2].map(a=>[e[a],t[a],i[a]])),o=a=>a.map(l=>Math.abs(l)<1e-15?0:l);return{xyz:o(s),rpy:o(r)}}function wl(n,e){let t=(i,s)=>n[3*i]*e[s]+n[3*i+1]*e[3+s]+n[3*i+2]*e[6+s];return[0,1,2].flatMap(i=>[0,1,2].map(s=>t(i,s)))}var Au=n=>[n[0],n[3],n[6],n[1],n[4],n[7],n[2],n[5],n[8]],_r=(n,e)=>[0,3,6].map(t=>n[t]*e[0]+n[t+1]*e[1]+n[t+2]*e[2]),Tu=n=>n===0?1:Math.sin(n)/n;function Ru(n){let e=Ot(n),[t,i]=[Tu(e),Tu(e/2)**2/2],s=[[1,0,0],[0,1,0],[0,0,1]].map(r=>{let o=pn(n,r);return Oe(Oe(r,be(o,t)),be(pn(n,o),i))});return Au(s.flat())}function wp(n){let e=be([n[7]-n[5],n[2]-n[6],n[3]-n[1]],.5),t=Math.atan2(Ot(e),(n[0]+n[4]+n[8]-1)/2);return be(e,1/Tu(t))}function Ex(n){let e=n*n;return n<.01?1/12+e*(1/720+e/30240):(1-n/2/Math.tan(n/2))/e}function Cu(n,e){let t=pn(n,e);return Oe(Oe(e,be(t,.5)),be(pn(n,t),Ex(Ot(n))))}var eo=[0,1,2,3,4,5].map(n=>{let e="xyz"[n%3];return n<3?{name:`base.v${e}`,axis:e,velocity:"v",force:"f",type:"prismatic"}:{name:`base.w${e}`,axis:e,velocity:"\u03C9",force:"n",type:"revolute"}}),Tl=["x","y","z","roll","pitch","yaw"].map((n,e)=>({name:n,type:e<3?"prismatic":"revolute"})),Ep=n=>n.slice(0,9),_s=n=>n.slice(9,12);function Tp([n,e,t,...i]){let s=es(zs,{xyz:[n,e,t],rpy:i});return[0,1,2].flatMap(r=>[s.x[r],s.y[r],s.z[r]]).concat(s.o)}function Ap(n){let[e,t,i]=[0,1,2].map(s=>[n[s],n[3+s],n[6+s]]);return{x:e,y:t,z:i,o:_s(n)}}var El=class{constructor(e){this.rotation=Ep(e),this.start=[0,0,0,..._s(e)]}pose(e){return[...wl(this.rotation,Ru(e.subarray(0,3))),...e.subarray(3,6)]}rate(e,t,i){return[...Cu(e.subarray(0,3),i.slice(3,6)),..._r(t,i)]}recenter(e){this.rotation=Ep(this.pose(e)),e.fill(0,0,3)}};function Pu(n,e,t,i){let[s,r]=[e-n,n-t];return i*(n+(1-i)*(s*(1-i)+r*i))}function Rp([n,e],[t,i],s,r){let o=wp(wl(Au(n),e)),a=(d,h,m)=>d.map((g,_)=>Pu(g,s*h[_],s*m[_],r)),l=a(o,t.slice(3,6),Cu(o,i.slice(3,6))),c=Oe(_s(e),be(_s(n),-1)),u=a(c,_r(n,t),_r(e,i));return[...wl(n,Ru(l)),...Oe(_s(n),u)]}var Tx="\u0307",Al=n=>({min:()=>-n,max:()=>n}),to=({state:n,changed:e},t,i)=>({get:()=>n[t][i],set(s){n[t][i]=s,e()}}),Iu=({units:n},e)=>({factor:()=>n().factor(e),unit:()=>n().position(e)}),Lu=n=>({state:n.state,changed:n.changed,units:()=>n.units});function Cp(n,e,{signs:t,name:i,most:s}){let{state:r}=n,{type:o}=n.freedoms[e],a=Lu(n),l={...Al(2*s.speed),...Iu(a,o),...to(a,"qd",e),unit:()=>n.units.velocity(o),label:t.velocity,key:`qd-${e}`,about:`${i}, velocity${r.mode==="pose"?"":" at the start"}`};if(r.mode==="pose"){let u={...l,...Al(4*s.speed),...to(a,"qdd",e),unit:()=>n.units.acceleration(o),label:t.acceleration,key:`qdd-${e}`,about:`${i}, acceleration`};return[l,u]}if(r.law!=="constant")return[l];let c={...Al(s.force),...to(a,"torque",e),factor:()=>1,unit:()=>n.units.force(o),label:t.force,key:`tau-${e}`,about:`${i}, ${o==="revolute"?"torque":"force"}`};return[l,c]}function Pp(n,e){let{state:t}=n,i=n.joints[e],[s,r]=n.ranges[e],o=Lu(n),a={min:()=>s,max:()=>r,...Iu(o,i.type)},l={...a,...to(o,"q",e),label:t.mode==="motion"||t.mode==="reach"?"start":fn("q",null),key:`q-${e}`,about:`${i.name}, position${t.mode==="pose"?"":" at the start"}`};if(t.mode==="reach")return[l];if(t.mode==="motion"){let h={...a,...to(o,"end",e),label:"end",key:`end-${e}`,about:`${i.name}, position at the end`};return[l,h]}let c=Math.max(1,...n.table.rows.map(h=>h.mass))*9.81,u={velocity:fn("q\u0307",null),acceleration:fn("q\u0308",null),force:fn("\u03C4",null)},d=i.type==="revolute"?{speed:Math.PI,force:c*n.size}:{speed:n.size,force:c};return[l,...Cp(n,n.ofBase+e,{signs:u,name:i.name,most:d})]}function Ip(n){let{state:e,size:t}=n,i=Lu(n),s=Tl.map(({name:c,type:u},d)=>({...Al(u==="revolute"?Math.PI:Math.max(2*t,1)),...Iu(i,u),...to(i,"pose",d),label:c,key:`pose-${d}`,about:`base, ${c}${e.mode==="free"?" at the start":""}`}));if(e.mode==="motion"||e.mode==="reach")return s;let{rows:r,floating:o}=n.table,a=9.81*r.reduce((c,{mass:u})=>c+u,o.mass),l=n.freedoms.slice(0,n.ofBase).map(({name:c,axis:u,velocity:d,force:h,type:m},g)=>{let _={velocity:fn(d,u),acceleration:fn(`${d}${Tx}`,u),force:fn(h,u)},f=m==="revolute"?{speed:Math.PI,force:a*t}:{speed:Math.max(2*t,2),force:2*a};return Cp(n,g,{signs:_,name:c,most:f})});return[...s,...l.map(([c])=>c),...l.flatMap(([,c])=>c??[])]}var xr=class extends Error{constructor(e){super(`not positive definite at index ${e}`),this.joint=e}};function no(n,e,t){let i=t.length,s=t.map(()=>new Array(i).fill(0)),r=t.map(o=>e[o]);for(let o=0;o<i;o++){for(let a=0;a<=o;a++){let l=n[t[o]][t[a]];for(let c=0;c<a;c++)l-=s[o][c]*s[a][c];if(o===a&&!(l>1e-14*Math.abs(n[t[o]][t[o]])))throw new xr(t[o]);s[o][a]=o===a?Math.sqrt(l):l/s[a][a]}for(let a=0;a<o;a++)r[o]-=s[o][a]*r[a];r[o]/=s[o][o]}for(let o=i-1;o>=0;o--){for(let a=o+1;a<i;a++)r[o]-=s[a][o]*r[a];r[o]/=s[o][o]}return r}var Du=eo.map((n,e)=>e),Lp={none:()=>(n,e,t)=>t.map(()=>0),constant:({torque:n})=>()=>n,gravity:({equations:n})=>(e,t)=>{let i=n.spring_vector(t);return n.gravity_vector(e,t).map((s,r)=>s+i[r])},steady:({equations:n,hasFriction:e})=>(t,i,s)=>{let r=n.inverse_dynamics(t,i,s,s.map(()=>0)),o=n.mass_matrix(i),a=no(o,r.map(c=>-c),Du),l=e?null:n.friction_vector(s);return r.map((c,u)=>u<Du.length?0:Du.reduce((d,h)=>d+o[u][h]*a[h],c-(l?.[u]??0)))}};function Dp({floating:n}){let e="none: free fall";return n?{none:e,steady:"of joints: they keep their velocities",constant:"constant, on the base too",gravity:"G + K, on the base too: the robot floats"}:{none:e,constant:"constant",gravity:"G + K: the arm floats"}}function Pi(n,e){return W("div",{class:"scroll",role:"region",tabIndex:0,"aria-label":n},e)}var oa=(n,e,t="")=>W("table",{class:`numbers${t}`},n&&W("caption",{},n),W("tbody",{},e.map(i=>W("tr",{},i)))),io=(...n)=>W("th",{scope:"row"},n),aa=n=>W("i",{},n),Rl=(n,e="")=>W("td",{class:`unit${e}`},n);function Np(n){let{joints:e,freedoms:t,ofBase:i,table:s}=n,r=s.rows.some(E=>E.viscous||E.coulomb.some(Boolean)||E.stribeck),o=s.rows.some(E=>E.spring),a=[{key:"q",sign:"q",unit:"position",isAngle:!0},{key:"qd",sign:"q\u0307",unit:"velocity",isAngle:!0},{key:"qdd",sign:"q\u0308",unit:"acceleration",isAngle:!0},{key:"tau",sign:"\u03C4",unit:"force"},{key:"coriolis",sign:"V",unit:"force"},{key:"gravity",sign:"G",unit:"force"},...o?[{key:"spring",sign:"K",unit:"force"}]:[],...r?[{key:"friction",sign:"F",unit:"force"}]:[]],l=new Map,c=E=>{let N=Sp(E);return l.set(E,N),W("td",{},N)},u=[...new Set(t.map(E=>E.type))],d=a.map(()=>W("th",{class:"unit",scope:"col"})),h=W("table",{class:"numbers wide"},W("caption",{},"State and forces"),W("thead",{},W("tr",{},W("th",{scope:"col"},"joint"),a.map(E=>W("th",{scope:"col"},aa(E.sign)))),W("tr",{},W("th",{class:"unit",scope:"col"},""),d)),W("tbody",{},t.map((E,N)=>{let z=N-i,O=io(W("span",{class:"dot"}),z<0?["base ",fn(E.velocity,E.axis)]:E.name);O.style.setProperty("--color",z<0?`var(--axis-${E.axis})`:`var(--joint-${z%8})`);let X=a.map(({key:H})=>H!=="q"?c(`${H}-${N}`):z<0?W("td"):c(`q-${z}`));return W("tr",{},O,X)}))),g=u.length>1?"kg m\xB2, kg m, kg":u[0]==="revolute"?"kg m\xB2":"kg",_=oa(["Mass matrix ",aa("M"),`, ${g}`],t.map((E,N)=>t.map((z,O)=>c(`mass-${N}-${O}`)))," matrix"),f=W("span",{},"Tip"),p=["x","y","z"],v=(E,N,z)=>oa([E," in the world"],p.map((O,X)=>[io(aa(O)),c(N(X)),Rl("m"),io(["roll","pitch","yaw"][X]),c(z(X)),Rl(null," angle")])),P=v(f,E=>`tip-${E}-3`,E=>`rpy-${E}`),b=i>0?v("Base",E=>`base-${E}`,E=>`baserpy-${E}`):null,C=[0,1,2,3].map(E=>[0,1,2,3].map(N=>c(`T-${E}-${N}`))),M=W("details",{},W("summary",{},"Transform of the tip, 4 \xD7 4"),Pi("Transform of the tip",oa(null,C," matrix"))),x=Object.entries({T:"kinetic",U:"potential","T + U":"total"}),y=oa("Energies, J",x.map(([E,N])=>[io(aa(E)),c(N)])),L=()=>oa(["Momentum in the world; ",aa("L")," about the centre of mass"],p.map((E,N)=>[io(fn("p",E)),c(`linear-${N}`),Rl("kg m/s"),io(fn("L",E)),c(`angular-${N}`),Rl("kg m\xB2/s")])),R=(E,N,z=1)=>Mp(l.get(E),N,pr(N*z));function I(){let{units:E}=n,N=n.evaluated();s.tips.length>1&&(f.textContent=n.tip().name),a.forEach(({key:O,isAngle:X})=>{(O==="q"?e:t).forEach((Z,te)=>R(`${O}-${te}`,N[O][te],X?E.factor(Z.type):1))});let z=N.mass.map((O,X)=>Math.abs(O[X]));if(t.forEach((O,X)=>t.forEach((H,Z)=>{R(`mass-${X}-${Z}`,N.mass[X][Z]);let te=Math.abs(N.mass[X][Z])/Math.sqrt(z[X]*z[Z]);l.get(`mass-${X}-${Z}`).parentElement.style.setProperty("--share",Number.isFinite(te)?Math.min(te,1).toFixed(3):0)})),N.tip.forEach((O,X)=>O.forEach((H,Z)=>R(`T-${X}-${Z}`,H))),[0,1,2].forEach(O=>R(`tip-${O}-3`,N.tip[O][3])),Qr(N.tip).forEach((O,X)=>R(`rpy-${X}`,O,E.factor("revolute"))),N.base){_s(N.base).forEach((X,H)=>R(`base-${H}`,X));for(let X of["linear","angular"])N.momentum[X].forEach((H,Z)=>R(`${X}-${Z}`,H));let O=[0,3,6].map(X=>N.base.slice(X,X+3));Qr(O).forEach((X,H)=>R(`baserpy-${H}`,X,E.factor("revolute")))}R("kinetic",N.kinetic),R("potential",N.potential),R("total",N.kinetic+N.potential)}function U(){a.forEach(({unit:E},N)=>{d[N].textContent=u.map(z=>n.units[E](z)).join(", ")}),k.querySelectorAll(".angle").forEach(E=>E.textContent=n.units.angleUnit),I()}let k=W("div",{class:"blocks"},Pi("Mass matrix",_),b&&Pi("Pose of the base",b),Pi("Pose of the tip",P),Pi("Energies",y),i>0?Pi("Momentum",L()):null);return n.on("units",U),n.on("time tip",I),U(),W("section",{class:"panel","aria-label":"Numbers"},Pi("State and forces",h),k,M)}function so({label:n,key:e,min:t,max:i,get:s,set:r,factor:o,unit:a,about:l}){let c=W("input",{type:"range",step:"any","data-key":e,"aria-label":l}),u=W("input",{type:"number",step:"any","aria-label":`${l}, as a number`}),d=W("span",{class:"unit"}),h=W("p",{class:"refused",role:"alert"}),m=W("div",{class:"slider"},W("span",{class:"what"},n),c,u,d,h),g=()=>{let[f,p]=[s(),o()],[v,P]=[Math.min(t(),f),Math.max(i(),f)];Object.assign(c,{min:v*p,max:P*p}),c.value=f*p,c.setAttribute("aria-valuetext",`${mt(f*p)} ${a()}`),(document.activeElement!==u||h.textContent)&&(u.value=mt(f*p,5)),d.textContent=a()},_=f=>{let p=Number(f)/o(),v=f.trim()!==""&&Number.isFinite(p),P=v?r(p):"expected a number";h.textContent=P?`${v?`${f} is refused: `:""}${P}`:"",g()};return c.addEventListener("input",()=>_(c.value)),u.addEventListener("change",()=>_(u.value)),g(),{row:m,show:g}}function Ax(n){let{state:e,size:t}=n;return Tl.slice(0,e.hasRotation?6:3).map(({name:i,type:s},r)=>{let o=s==="revolute"?Math.PI:1.2*t;return so({label:i,key:`target-${r}`,about:`target, ${i}`,min:()=>-o,max:()=>o,get:()=>e.target[r],set(a){e.target[r]=a,n.seek()},factor:()=>n.units.factor(s),unit:()=>n.units.position(s)})})}function Up(n){let{state:e,joints:t}=n,i=Ax(n),s=W("input",{type:"checkbox",checked:e.hasRotation,"data-key":"rotation"});s.addEventListener("change",()=>{e.hasRotation=s.checked,n.seek(),n.tell("mode")});let r=W("div",{class:"head"},W("span",{class:"name"},W("b",{},"target"),` of ${n.tip().name}`),W("label",{class:"check"},s,"with its rotation")),o=W("p",{class:"said","data-key":"reached",role:"status"}),a=W("table",{class:"numbers solutions"}),l=(_,f,p)=>W("button",{type:"button",class:"chip","data-key":f,onclick:p},_),c=(_,f)=>W("tr",{class:f===e.reached.chosen?"chosen":""},W("th",{scope:"row"},String(f+1)),W("td",{},l("start",`start-${f}`,()=>n.choose(f,!0)),l("end",`solution-${f}`,()=>n.choose(f))),_.map((p,v)=>W("td",{},W("data",{value:String(p),title:String(p)},pr(p*n.units.factor(t[v].type))))));function u(){let{found:_,missing:f}=e.reached;a.hidden=_.length===0;let p=["","of the motion",...t.map(({name:v,type:P})=>`${v}, ${n.units.position(P)}`)];a.replaceChildren(W("thead",{},W("tr",{},p.map(v=>W("th",{scope:"col"},v)))),W("tbody",{},_.map(c))),o.classList.toggle("refused",f!==null),o.textContent=f?h(f):`${_.length} ${_.length===1?"solution":"solutions"} found: ${d()}.`}function d(){return e.reached.chosen>=0?"the motion goes to that which is marked":n.trajectory.ended?"the motion does not come to any":"the straight line ends at positions that are none of these"}function h({way:_,turn:f}){let{factor:p,angleUnit:v}=n.units,P=2*Math.asin(Math.min(1,f/2))*p("revolute"),b=e.hasRotation?` and ${mt(P,3)} ${v}`:"";return`No solution found: ${mt(_,3)} m${b} are missing at the nearest positions, to which the motion goes.`}function m(){i.forEach(_=>_.show()),u()}return m(),{group:W("div",{class:"joint base"},r,i.map(_=>_.row),o,Pi("Solutions",a)),show:m}}var Rx=[.001,1e3],Cx={motion:"Motion",reach:"Reach",free:"Free motion",pose:"Pose"},Px={motion:"From start to end, from rest to rest; inverse dynamics gives the torques.",reach:"From the start to where the tip is at the target, dragged in the picture or typed: inverse kinematics, then inverse dynamics.",free:"From the start under given torques; forward dynamics gives the motion.",pose:"One state; inverse dynamics gives the torques that it takes."},Ix={motion:"The base is held where it is, and the joints go from start to end, from rest to rest; inverse dynamics gives the torques, and the force and the moment that hold the base.",reach:"The base is held where it is. From the start to where the tip is at the target, dragged in the picture or typed: inverse kinematics, then inverse dynamics.",free:"Base and joints move freely from the start; forward dynamics gives the motion.",pose:"One state; inverse dynamics gives the torques that it takes, and the force and the moment on the base."};function Lx(n,{name:e,value:t,unit:i}){let s=i==="rad",[r,o]=s?[-Math.PI,Math.PI]:t<0?[3*t,0]:[0,3*t||1];return so({label:W("i",{},e),key:`field-${e}`,about:i?`field ${e}`:`field ${e}, without unit`,min:()=>r,max:()=>o,get:()=>n.fields[e],set:a=>n.setFields({[e]:a}),factor:()=>s?n.units.factor("revolute"):1,unit:()=>s?n.units.angleUnit:i})}function Dx({about:n,key:e,options:t,get:i,set:s}){let r=Object.entries(t).map(([a,l])=>W("option",{value:a},l)),o=W("select",{"data-key":e,onchange:()=>s(o.value)},r);return o.value=i(),W("label",{class:"choice"},W("span",{},n),o)}function Nx({rows:n},e){let{on:t}=n[e];return n.filter(s=>!s.isPlace&&s.on===t).length>1||(t??-1)!==e-1?`on ${t===null?"the base":n[t].name}`:null}function Fp(n){let{state:e,joints:t,first:i}=n,s=[],o=Object.entries(Cx).filter(([E])=>E!=="reach"||t.length>0).map(([E,N])=>W("button",{type:"button",role:"tab","data-key":`mode-${E}`,onclick:()=>n.setMode(E)},N)),a=W("div",{class:"tabs",role:"tablist","aria-label":"Kind of motion"},o);a.addEventListener("keydown",({key:E})=>{let N={ArrowRight:1,ArrowLeft:-1}[E];if(!N)return;let z=o.findIndex(X=>X.getAttribute("aria-selected")==="true"),O=o[(z+N+o.length)%o.length];O.focus(),O.click()});let l=W("p",{class:"said"}),c=W("div",{class:"settings"}),u=W("div",{class:"joints"}),d=W("div",{role:"tabpanel"},l,c,u),[h,m]=Rx,g=W("input",{type:"number",min:h,max:m,step:"any","data-key":"duration"}),_=W("p",{class:"refused",role:"alert"});g.addEventListener("change",()=>{let E=Number(g.value),N=E>=h&&E<=m;_.textContent=N?"":`expected a number from ${h} to ${m}`,N&&(e.duration=E),g.value=e.duration,n.changed()});let f={cycloidal:"cycloidal",quintic:"quintic polynomial",cubic:"cubic polynomial"},p={joints:"each joint by itself",line:"straight line of the tip"},v=Dp(n.table),P=n.table.floating?Ix:Px,b=n.table.rows.some(E=>E.viscous!==0||E.coulomb.some(N=>N!==0)||E.stribeck),C=null;function M(){o.forEach(z=>{let O=z.dataset.key===`mode-${e.mode}`;z.setAttribute("aria-selected",O),z.tabIndex=O?0:-1}),l.textContent=P[e.mode],g.value=e.duration;let E=[];e.mode!=="pose"&&E.push(W("label",{class:"choice"},W("span",{},"duration, s"),g),_);let N=(z,O,X)=>{let H=Z=>{e[O]=Z,O==="law"&&M(),n.changed()};E.push(Dx({about:z,key:O,options:X,get:()=>e[O],set:H}))};if((e.mode==="motion"||e.mode==="reach")&&N("profile","profile",f),e.mode==="reach"&&N("way","path",p),e.mode==="free"&&(N("torques","law",v),b)){let z=W("input",{type:"checkbox",checked:e.hasFriction,"data-key":"friction"});z.addEventListener("change",()=>{e.hasFriction=z.checked,n.changed()}),E.push(W("label",{class:"check"},z,"friction"))}c.replaceChildren(...E),s.length=0,C=e.mode==="reach"?Up(n):null,u.replaceChildren(...C?[C.group]:[],...n.table.floating?[x()]:[],...t.flatMap((z,O)=>{let X=Pp(n,O).map(so);s.push(...X);let H=n.table.rows.findIndex(ge=>ge.joint===O),Z=W("button",{type:"button",class:"name",onclick:()=>n.select(H)});Z.append(W("span",{class:"dot"}),W("b",{},String(O+1)),` ${z.name}`);let te=W("span",{class:"kind"},z.type),le=W("span",{class:"kind limits"}),he=W("div",{class:"head"},Z,te,le),Q=W("div",{class:"joint","data-joint":O},he,X.map(ge=>ge.row));Q.addEventListener("focusin",()=>n.select(H));let me=Nx(n.table,H);return me===null?Q:[W("h3",{class:"branch"},me),Q]})),L(),y()}function x(){let E=Ip(n).map(so);s.push(...E);let N=W("span",{class:"name"},W("b",{},"base")),z=W("span",{class:"kind"},"velocities and forces in its own axes");return W("div",{class:"joint base"},W("div",{class:"head"},N,z),E.map(O=>O.row))}function y(){let{factor:E,position:N}=n.units;u.querySelectorAll(".limits").forEach((z,O)=>{let{limits:X,type:H}=t[O],Z=X?.map(te=>mt(te*E(H),4));z.textContent=Z?`${Z[0]} to ${Z[1]} ${N(H)}`:"no limits"})}function L(){u.querySelectorAll("[data-joint]").forEach((E,N)=>{let{selected:z}=e;E.classList.toggle("selected",n.table.rows[z]?.joint===N),E.style.setProperty("--color",`var(--joint-${N%8})`)})}let R=i.fields.map(E=>Lx(n,E)),I=W("div",{class:"fields"},W("h3",{},"Parameters"),R.map(E=>E.row));n.on("mode",M),n.on("units",()=>{[...s,...R,...C?[C]:[]].forEach(E=>E.show()),y()}),n.on("selection",L),n.on("reached",()=>{s.forEach(E=>E.show()),C?.show()}),n.on("tip",()=>e.mode==="reach"&&M()),M();let U=W("button",{type:"button",class:"quiet",onclick(){let E=X=>e[X].fill(0);["qdd","torque"].forEach(E),["pose","qd"].forEach(X=>k[X].forEach((H,Z)=>e[X][Z]=H));let{from:N,to:z,duration:O}=i;k.q.forEach((X,H)=>e.q[H]=N?.[H]??X),k.end.forEach((X,H)=>e.end[H]=z?.[H]??X),e.duration=O,n.setFields(Object.fromEntries(i.fields.map(({name:X,value:H})=>[X,H]))),M(),R.forEach(X=>X.show()),n.changed()}});U.append("Reset");let k={q:[...e.q],end:[...e.end],pose:[...e.pose],qd:[...e.qd]};return W("section",{class:"panel controls","aria-label":"Settings"},W("div",{class:"bar"},a,U),d,i.fields.length>0?I:null)}var Ux=[[0,1],[0,2],[1,2]];function Fx([n,e,t,i,s,r]){let o=[[n,i,r],[i,e,s],[r,s,t]],a=[[1,0,0],[0,1,0],[0,0,1]];for(let l=0;l<12;l++)for(let[c,u]of Ux){if(o[c][u]===0)continue;let d=Math.atan2(2*o[c][u],o[u][u]-o[c][c])/2,[h,m]=[Math.sin(d),Math.cos(d)],g=_=>_.forEach(f=>[f[c],f[u]]=[m*f[c]-h*f[u],h*f[c]+m*f[u]]);g(o),[o[c],o[u]]=[o[c].map((_,f)=>m*_-h*o[u][f]),o[c].map((_,f)=>h*_+m*o[u][f])],g(a)}return{moments:[o[0][0],o[1][1],o[2][2]],axes:a}}function Cl({mass:n,inertia:e}){let{moments:t,axes:i}=Fx(e),s=t[0]+t[1]+t[2],r=t.map(c=>n>0?Math.sqrt(Math.max(0,6*(s-2*c)/n))/2:0),[o,a,l]=[0,1,2].map(c=>i.map(u=>u[c]));return{x:o,y:a,z:l,half:r}}function Ox(n,e){return n.rows.map(t=>t.joint!==null?e[t.joint]:t.follows?t.follows.factor*e[t.follows.joint]+t.follows.offset:t.locked)}function Ii(n,e,t){let i=t?Ap(t):n.base?es(zs,n.base):zs,s=Ox(n,e),r=[];n.rows.forEach((a,l)=>{let c=a.on===null?i:r[a.on].frame,u=a.step.reduce(es,c),d=a.type==="prismatic",h=a.theta+(d?0:s[l]),m=a.d+(d?s[l]:0),g=(f,p,v)=>{let P=a.mount?a.mount.frame.reduce(es,p):p;r.push({before:u,middle:f,frame:p,link:P,theta:h,d:m,origin:v.o,axis:v.z})};if(n.convention==="standard"){let f=wu(u,m,h);g(f,Eu(f,a.a,a.alpha),u);return}let _=Eu(u,a.a,a.alpha);g(_,wu(_,m,h),_)});let o=n.tips.map(({on:a,places:l})=>l.reduce(es,a===null?i:r[a].link));return{base:i,rows:r,tips:o}}function Op(n,e){let t=new Array(n.joints).fill(0),{base:i,rows:s,tips:r}=Ii(n,t,null),o=[],a=h=>h===null?{way:0,at:i.o}:o[h],l=({way:h,at:m},g)=>({way:h+Qi(m,g),at:g});s.forEach(({middle:h,frame:m,link:g},_)=>{let{on:f,isPlace:p}=n.rows[_],v=n.isMounted?p?[]:[g.o]:[h.o,m.o];o.push(v.reduce(l,a(f)))});let c=n.tips.map(({on:h},m)=>l(a(h),r[m].o).way),u=Math.max(0,...o.map(({way:h})=>h),...c)+e,d=n.rows.map(h=>Math.hypot(...h.com));if(n.floating){let{com:h}=n.floating;d.push(Ot(Oe(h,Cl(n.floating).half)))}return Math.max(u,...d)||1}function Bp(n,e,t){let i=e.slice(0,6).map(a=>a.reduce((l,c,u)=>l+c*t[u],0)),[s,r]=[i.slice(0,3),i.slice(3)],o=be([e[1][5],e[2][3],e[0][4]],1/(e[0][0]||1));return{linear:_r(n,s),angular:_r(n,At(r,pn(o,s)))}}var Bx=["mass_matrix","coriolis_vector","kinetic_energy","friction_vector","spring_vector"];function kp(n,e,t){let i=Object.keys(n).filter(o=>/^[a-z]/.test(o)),s=n.FIELD_NAMES!==void 0,r=o=>{let a=s?(...l)=>n[o](e,...l):n[o];return t||Bx.includes(o)?a:(l,...c)=>a(...c)};return Object.fromEntries(i.map(o=>[o,r(o)]))}function zp(n,{base:e,q:t,qd:i,qdd:s,tau:r,friction:o},{key:a}){let l=n.gravity_vector(e,t),c=n.friction_vector(i),u=n.spring_vector(t),d=n.mass_matrix(t),h=n.inverse_dynamics(e,t,i,i.map(()=>0));return{base:e,q:t,qd:i,qdd:s,tau:r,mass:d,momentum:e&&Bp(e,d,i),coriolis:h.map((m,g)=>m-l[g]-u[g]-c[g]),gravity:l,friction:o??c,spring:u,tip:n[a](e,t),kinetic:n.kinetic_energy(t,i),potential:n.potential_energy(e,t)}}var la=2*Math.PI,Nu={cycloidal:n=>[n-Math.sin(la*n)/la,1-Math.cos(la*n),la*Math.sin(la*n)],quintic:n=>[n**3*(10+n*(6*n-15)),30*n**2*(1-n)**2,60*n*(1-n)*(1-2*n)],cubic:n=>[n*n*(3-2*n),6*n*(1-n),6-12*n]};function Vp({from:n,to:e,duration:t,profile:i},s){let[r,o,a]=Nu[i](Math.min(Math.max(s/t,0),1)),l=c=>n.map((u,d)=>c(e[d]-u,u));return{q:l((c,u)=>u+c*r),qd:l(c=>c*o/t),qdd:l(c=>c*a/t**2)}}var ca=(n,e)=>n.reduce((t,i,s)=>t+i*e[s],0);function Pl(n){let e=n.map(o=>[...o]),t=n.map((o,a)=>n.map((l,c)=>a===c?1:0)),i=(o,a,l,c,u)=>{let[d,h]=[o[a],o[l]];o[a]=d.map((m,g)=>c*m-u*h[g]),o[l]=d.map((m,g)=>u*m+c*h[g])},s=!1;for(let o=0;o<40&&!s;o++){s=!0;for(let a=0;a<e.length;a++)for(let l=0;l<a;l++){let[c,u,d]=[ca(e[l],e[l]),ca(e[a],e[a]),ca(e[l],e[a])];if(Math.abs(d)<=1e-15*Math.sqrt(c*u))continue;s=!1;let h=(u-c)/(2*d),m=(h<0?-1:1)/(Math.abs(h)+Math.hypot(1,h)),g=1/Math.hypot(1,m);[e,t].forEach(_=>i(_,l,a,g,g*m))}}let r=e.map((o,a)=>({value:Math.sqrt(ca(o,o)),u:o,v:t[a]}));return r.forEach(o=>o.u=o.u.map(a=>a/(o.value||1))),r.sort((o,a)=>a.value-o.value)}var ro=(n,e,t,i)=>n.reduce((s,r)=>s.map((o,a)=>o+ca(r[e],i)/r.value*r[t][a]),n[0][t].map(()=>0));var yr=1e-9,[Il,kx]=[5,60],[Gp,Hp]=[.1,1e-12],zx=1e-9,[Vx,Gx]=[120,.001],Uu=["x","y","z"];function Ll(n,e){let t=Uu.map(a=>pn(n[a],e[a])).reduce(Oe),i=1+Uu.reduce((a,l)=>a+hi(n[l],e[l]),0);if(i>1e-6)return be(t,1/Math.sqrt(i));let s=a=>Uu.reduce((l,c)=>Oe(l,be(e[c],n[c][a])),[0,1,2].map(l=>l===a?1:0)),o=[0,1,2].map(s).reduce((a,l)=>Ot(l)>Ot(a)?l:a);return be(o,2/Ot(o))}function Wp(n,e){let t=new Set;for(let i=n.tips[e].on;i!==null;i=n.rows[i].on)t.add(n.rows[i].joint??n.rows[i].follows?.joint);return t.delete(void 0),t.size}function da({table:n,base:e,tip:t},i){let{rows:s,tips:r}=Ii(n,i,e),o=i.map(()=>[0,0,0,0,0,0]);for(let a=n.tips[t].on;a!==null;a=n.rows[a].on){let{joint:l,follows:c,type:u}=n.rows[a],{joint:d,factor:h}=l===null?c??{joint:null}:{joint:l,factor:1};if(d===null)continue;let{axis:m,origin:g}=s[a],_=u==="prismatic"?[...m,0,0,0]:[...pn(m,At(r[t].o,g)),...m];o[d]=o[d].map((f,p)=>f+h*_[p])}return{frame:r[t],columns:o}}function Fu(n,e){let{target:t,size:i,hasRotation:s}=n,{frame:r,columns:o}=da(n,e),a=At(t.o,r.o),l=s?Ll(r,t):[0,0,0],c=[1,1,1].map(m=>m/i).concat(s?[1,1,1]:[0,0,0]),u=[...a,...l].map((m,g)=>m*c[g]),d=o.map(m=>m.map((g,_)=>g*c[_])),h=(m,g)=>m.reduce((_,f,p)=>_+f*g[p],0);return{way:Ot(a),turn:Ot(l),isReached:Ot(a)<=yr&&Ot(l)<=yr,error:h(u,u)/2,descent:d.map(m=>h(m,u)),matrix:d.map(m=>d.map(g=>h(m,g)))}}var qp=({matrix:n})=>Math.max(0,...n.map((e,t)=>e[t]));function Xp({limits:n},{matrix:e,descent:t},i,s){let r=e.map((l,c)=>l.map((u,d)=>c===d?u+i:u)),o=s.map(()=>0),a=s.map((l,c)=>c);for(let l=0;l<4&&a.length>0;l++){let c=t.map((h,m)=>s.reduce((g,_,f)=>a.includes(f)?g:g-r[m][f]*o[f],h)),u;try{u=no(r,c,a)}catch(h){if(h instanceof xr)return null;throw h}a.forEach((h,m)=>o[h]=ha(s[h]+u[m],n[h])-s[h]);let d=a.filter((h,m)=>o[h]===s[h]+u[m]-s[h]);if(d.length===a.length)break;a=d}return s.map((l,c)=>ha(l+o[c],n[c]))}var ha=(n,e)=>e?Math.min(Math.max(n,e[0]),e[1]):n;function Yp(n,e){let t=e.map((s,r)=>ha(s,n.limits[r])),i=1/0;for(let s=0;;s++){let r=Fu(n,t),o=s%Il===Il-1&&!(r.error<i/2);if(r.isReached||o||s===kx)return{q:t,...r};s%Il===Il-1&&(i=r.error);let a=qp(r),l=Xp(n,r,Gp*Math.min(r.error,a)+Hp*a,t);if(l===null)return{q:t,...r};t=l}}function $p(n,e){let t=e.map((o,a)=>ha(o,n.limits[a])),i=Fu(n,t),s=qp(i),r=Gp*s;for(let o=0;o<200&&!i.isReached&&r<1e9*s;o++){let a=Xp(n,i,r,t);if(a===null)break;let l=Fu(n,a);i.error-l.error<zx*i.error?r*=4:[t,i,r]=[a,l,Math.max(r/4,Hp*s)]}return{q:t,...i}}function Zp(n,e){let t=Yp(n,e);return t.isReached?t:$p(n,e)}function Ou(n){let e=n;return()=>{e=e+1831565813|0;let t=Math.imul(e^e>>>15,1|e);return t=t+Math.imul(t^t>>>7,61|t)^t,((t^t>>>14)>>>0)/2**32}}function ua({table:n,limits:e},t,i){let s=o=>n.rows.some(({follows:a})=>a?.joint===o),r=n.rows.filter(({joint:o})=>o!==null);return t.map((o,a)=>{if(r[a].type!=="revolute"||s(a))return o;let l=2*Math.PI,c=o-l*Math.round((o-i[a])/l);return[c,c+l,c-l].find(d=>ha(d,e[a])===d)??o})}function Dl({joints:n},e,t){let i=2*Math.PI;return e.every((s,r)=>Math.abs(s-t[r]-(n[r].type==="revolute"?i*Math.round((s-t[r])/i):0))<Gx)}function jp(n,e,t=16){let i=Ou(1),s=()=>n.ranges.map(([c,u])=>c+(u-c)*i()),r=[],o=null;for(let c=0;c<Vx&&r.length<t;c++){let u=Yp(n,c===0?e:s());if((o===null||u.error<o.error)&&(o=u),!u.isReached)continue;let d=ua(n,u.q,e);r.some(h=>Dl(n,d,h))||r.push(d)}let a=c=>Math.max(...c.map((u,d)=>Math.abs(u-e[d])));if(r.sort((c,u)=>a(c)-a(u)),r.length>0)return{found:r,missing:null};let l=$p(n,o.q);return{found:r,missing:{...l,q:ua(n,l.q,e)}}}var Bu=[0,.05260015195876773,.0789002279381516,.1183503419072274,.2816496580927726,.3333333333333333,.25,.3076923076923077,.6512820512820513,.6,.8571428571428571,1],Nl=[[],[[0,.05260015195876773]],[[0,.0197250569845379],[1,.0591751709536137]],[[0,.02958758547680685],[2,.08876275643042054]],[[0,.2413651341592667],[2,-.8845494793282861],[3,.924834003261792]],[[0,.037037037037037035],[3,.17082860872947386],[4,.12546768756682242]],[[0,.037109375],[3,.17025221101954405],[4,.06021653898045596],[5,-.017578125]],[[0,.03709200011850479],[3,.17038392571223998],[4,.10726203044637328],[5,-.015319437748624402],[6,.008273789163814023]],[[0,.6241109587160757],[3,-3.3608926294469414],[4,-.868219346841726],[5,27.59209969944671],[6,20.154067550477894],[7,-43.48988418106996]],[[0,.47766253643826434],[3,-2.4881146199716677],[4,-.590290826836843],[5,21.230051448181193],[6,15.279233632882423],[7,-33.28821096898486],[8,-.020331201708508627]],[[0,-.9371424300859873],[3,5.186372428844064],[4,1.0914373489967295],[5,-8.149787010746927],[6,-18.52006565999696],[7,22.739487099350505],[8,2.4936055526796523],[9,-3.0467644718982196]],[[0,2.273310147516538],[3,-10.53449546673725],[4,-2.0008720582248625],[5,-17.9589318631188],[6,27.94888452941996],[7,-2.8589982771350235],[8,-8.87285693353063],[9,12.360567175794303],[10,.6433927460157636]],[[0,.054293734116568765],[5,4.450312892752409],[6,1.8915178993145003],[7,-5.801203960010585],[8,.3111643669578199],[9,-.1521609496625161],[10,.20136540080403034],[11,.04471061572777259]]],Jp=[[0,.01312004499419488],[5,-1.2251564463762044],[6,-.4957589496572502],[7,1.6643771824549864],[8,-.35032884874997366],[9,.3341791187130175],[10,.08192320648511571],[11,-.022355307863886294]],Kp=[[0,.2440944881889764],[8,.7338466882816118],[11,.022058823529411766]];var Hx=1e-10;function fa(n,e,t,i){let s=Float64Array.from(n);for(let[r,o]of t){let a=i[r];for(let l=0;l<s.length;l++)s[l]+=e*o*a[l]}return s}function Ul(n,e,t,i,s){let r=[i];for(let g=1;g<Bu.length;g++)r.push(n(e+Bu[g]*s,fa(t,s,Nl[g],r)));let o=fa(t,s,Nl[12],r),a=new Float64Array(t.length),l=fa(a,1,Nl[12],r),c=fa(a,1,Kp,r),u=fa(a,1,Jp,r),[d,h]=[0,0];for(let g=0;g<t.length;g++){let _=Hx*(1+Math.max(Math.abs(t[g]),Math.abs(o[g])));d+=(u[g]/_)**2/t.length,h+=((l[g]-c[g])/_)**2/t.length}let m=d===0?0:s*d/Math.sqrt(d+.01*h);return{end:o,error:m}}function ku(n,e){if(!Number.isFinite(n))return 1/3;let t=.9*n**(-1/8);return Math.min(Math.max(t,1/3),e?1:6)}function Wx(n){let e=Array.from({length:n.dof},()=>[]),t=n.dof-n.joints;for(let i of n.rows)i.joint!==null?e[t+i.joint].push({row:i,factor:1}):i.follows&&e[t+i.follows.joint].push({row:i,factor:i.follows.factor});return e}var Qp=(n,e)=>e>0?n.coulomb[0]:n.coulomb[1],qx=(n,e)=>n.stribeck?n.stribeck.friction:Qp(n,e);function em(n){let e=Wx(n);return{isDry:e.map(t=>t.some(({row:i})=>i.coulomb[0]!==0||i.coulomb[1]!==0||i.stribeck!==null)),breakaway:(t,i)=>e[t].reduce((s,{row:r,factor:o})=>s+Math.abs(o)*qx(r,i*Math.sign(o)),0),sliding:(t,i,s)=>e[t].reduce((r,{row:o,factor:a})=>{let l=a*s,c=Math.sign(a)*i,u=Qp(o,c),d=o.stribeck?(o.stribeck.friction-u)*Math.exp(-((l/o.stribeck.velocity)**2)):0;return r+a*(o.viscous*l+c*(u+d))},0)}}var Xx=6e5,Yx=200;function $x(n,e){let t=e-(n.dof-n.joints);if(t<0)return"the mass matrix is singular at the base: no inertia resists its motion";let{name:i}=n.rows.find(s=>s.joint===t);return`the mass matrix is singular at joint ${t+1}, \`${i}\`: no inertia resists its motion`}var oo=class extends Error{},zu=class{constructor(e,t,i,s,r){vp(this,"rate",(e,t)=>{let i=this.state(t),{base:s,qd:r}=i,{tau:o,friction:a,qdd:l}=this.solve(i),c=r.reduce((u,d,h)=>u+d*(o[h]-a[h]),0);return this.chart?Float64Array.from([...this.chart.rate(t,s,r),...r.slice(this.ofBase),...l,c]):Float64Array.from([...r,...l,c])});this.chart=i&&new El(i),this.ofBase=t.dof-t.joints,this.equations=e,this.torque=s,this.hasFriction=r,this.dry=em(t),this.dof=t.dof,this.evaluations=0,this.contacts=new Array(t.dof).fill(0),this.sticks=r&&this.dry.isDry.some(Boolean)}friction(e){return this.hasFriction?e.map((t,i)=>{let s=this.contacts[i];return s===null?0:this.dry.sliding(i,s||Math.sign(t),t)}):e.map(()=>0)}solve({base:e,q:t,qd:i}){if(++this.evaluations>Xx)throw new oo("it takes too many steps");let s=this.torque(e,t,i),r=this.friction(i);if(!this.contacts.includes(null)){let g=this.equations.friction_vector(i),_=s.map((f,p)=>f+(g[p]-r[p]));return{tau:s,friction:r,qdd:this.equations.forward_dynamics(e,t,i,_),hold:null}}let o=i.map(()=>0),a=this.equations.friction_vector(i),l=this.equations.inverse_dynamics(e,t,i,o).map((g,_)=>g-a[_]),c=this.equations.mass_matrix(t),u=this.contacts.flatMap((g,_)=>g===null?[]:[_]),d=s.map((g,_)=>g-l[_]-r[_]),h=o;no(c,d,u).forEach((g,_)=>h[u[_]]=g);let m=s.map((g,_)=>this.contacts[_]!==null?0:c[_].reduce((f,p,v)=>f-p*h[v],g-l[_]));return{tau:s,friction:r,qdd:h,hold:m}}state(e){let t=this.dof;return{base:this.chart&&this.chart.pose(e),q:Array.from(e.subarray(this.ofBase,t)),qd:Array.from(e.subarray(t,2*t))}}margins(e){if(!this.sticks)return[1/0];let t=this.state(e),i=this.contacts.includes(null)?this.solve(t).hold:null;return this.contacts.map((s,r)=>s===null?this.dry.breakaway(r,Math.sign(i[r]))-Math.abs(i[r]):s===0?1/0:s*t.qd[r])}settle(e){if(!this.sticks)return;let t=this.state(e);for(this.contacts=t.qd.map((i,s)=>this.dry.isDry[s]?i===0?null:Math.sign(i):0);this.contacts.includes(null);){let{hold:i}=this.solve(t),s=this.contacts.map((o,a)=>o!==null||i[a]===0?0:Math.abs(i[a])/this.dry.breakaway(a,Math.sign(i[a]))),r=s.indexOf(Math.max(...s));if(!(s[r]>1))return;this.contacts[r]=Math.sign(i[r])}}};function Zx(n,e,t,i,s){let[r,o]=[0,s];for(let a=0;a<60&&o-r>1e-12*s;a++){let l=(r+o)/2,{end:c}=Ul(n.rate,e,t,i,l);Math.min(...n.margins(c))<0?o=l:r=l}return o}function jx(n,e,t){let{t:i,y:s,h:r}=e,o=0,a=!1;for(;t-i>1e-12*Math.max(1,t);){let l=n.rate(i,s),c=Math.min(r,t-i),{end:u,error:d}=Ul(n.rate,i,s,l,c);if(!(d<=1)){if(r=c*ku(d,!0),a=!0,!(r>1e-12))throw new oo("its steps become too small");continue}if(Math.min(...n.margins(u))<0){if(++o>Yx)throw new oo("a joint sticks and lets go without end");let m=Zx(n,i,s,l,c);s=Ul(n.rate,i,s,l,m).end,i+=m,n.chart?.recenter(s),n.contacts.forEach((g,_)=>{g&&g*s[n.dof+_]<=0&&(s[n.dof+_]=0)}),n.settle(s);continue}[i,s]=[i+c,u],n.chart?.recenter(s);let h=c*ku(d,a);r=c<r&&d<.1?Math.max(r,h):h,a=!1}return{t,y:s,h:r}}function tm({equations:n,table:e,law:t,torque:i,hasFriction:s,base:r,q:o,qd:a,duration:l,samples:c}){let u=Lp[t]({equations:n,torque:i,hasFriction:s}),d=new zu(n,e,r,u,s),h={t:[],base:[],q:[],qd:[],qdd:[],tau:[],friction:[],work:[],ended:null},m={t:0,y:Float64Array.from([...d.chart?.start??[],...o,...a,0]),h:l/c};try{d.settle(m.y);for(let g=0;g<c;g++){let _=l*g/(c-1);m=jx(d,m,_);let f=d.state(m.y),{qdd:p,tau:v,friction:P,hold:b}=d.solve(f);h.t.push(_),h.base.push(f.base),h.q.push(f.q),h.qd.push(f.qd),h.qdd.push(p),h.tau.push(v),h.friction.push(P.map((C,M)=>d.contacts[M]===null?b[M]:C)),h.work.push(m.y[2*d.dof])}}catch(g){let _=g instanceof xr||g.name==="SingularMassMatrix";if(!(g instanceof oo)&&!_)throw g;h.ended={t:m.t,reason:_?$x(e,g.joint):g.message}}return h}var Jx=100,[Kx,Qx]=[201,10001];function Fl(n){return Math.min(Math.max(Math.round(Jx*n)+1,Kx),Qx)}function nm(n,e){let t=Fl(e.duration),{base:i}=e,s=i?eo.map(()=>0):[],r=u=>{let{q:d,...h}=Vp(e,u),[m,g]=[h.qd,h.qdd].map(_=>[...s,..._]);return{base:i,q:d,qd:m,qdd:g,tau:n.inverse_dynamics(i,d,m,g)}},o=Array.from({length:t},(u,d)=>e.duration*d/(t-1)),a=o.map(r),l=u=>a.map(d=>d[u]),c={t:o,base:l("base"),q:l("q"),qd:l("qd"),qdd:l("qdd"),tau:l("tau")};return Ol(n,{...c,at:r,ended:null,duration:e.duration},e)}function im(n,e){let t=tm({...e,equations:n,samples:Fl(e.duration)});t.t.length===0&&ey(t,e);let i=t.t.length>0?t.t[t.t.length-1]:0,s=Ol(n,{...t,duration:i,at:u=>Vu(t,u)},e),{total:r,kinetic:o,potential:a}=s,l=r.map((u,d)=>Math.abs(u-r[0]-t.work[d])),c=u=>Math.max(...u)-Math.min(...u);return s.drift=Math.max(0,...l),s.energyScale=Math.max(c(o),c(a),c(t.work),0),s}function ey(n,{base:e,q:t,qd:i}){let s=i.map(()=>NaN);for(let[r,o]of Object.entries({t:0,base:e,q:t,qd:i,qdd:s,tau:s,friction:s,work:0}))n[r].push(o)}function Ol(n,e,{key:t}){let{base:i,q:s,qd:r}=e,o=s.map((u,d)=>n.kinetic_energy(u,r[d])),a=s.map((u,d)=>n.potential_energy(i[d],u)),l=o.map((u,d)=>u+a[d]),c=s.map((u,d)=>n[t](i[d],u).slice(0,3).map(h=>h[3]));return{...e,kinetic:o,potential:a,total:l,tip:c}}function Vu(n,e){let{t}=n,i=t.length-1,s=m=>Object.fromEntries(["base","q","qd","qdd","tau","friction"].map(g=>[g,n[g]?.[m]]));if(i<1)return s(0);let r=t[1]-t[0],o=Math.min(Math.max(Math.floor(e/r),0),i-1),a=Math.min(Math.max((e-t[o])/r,0),1);if(a===0||a===1)return s(o+a);let[l,c]=[s(o),s(o+1)],u=l.qd.length-l.q.length,d=(m,g,_)=>l[m].map((f,p)=>f+Pu(c[m][p]-f,r*l[g][_+p],r*c[g][_+p],a)),h=m=>m[o].map((g,_)=>g+a*(m[o+1][_]-g));return{base:l.base&&Rp([l.base,c.base],[l.qd,c.qd],r,a),q:d("q","qd",u),qd:d("qd","qdd",0),qdd:h(n.qdd),tau:h(n.tau),friction:n.friction&&h(n.friction)}}function sm(n,e){let t=["q","qd","qdd","tau"],[i]=n.base,s=u=>e.slice(e.length-n[u][0].length),r=t.flatMap(u=>s(u).map(d=>`${u}_${d}`)),a=[...[1,2,3].flatMap(u=>[1,2,3].map(d=>`r${u}${d}`)),"x","y","z"].map(u=>`base.${u}`),l=["t",...i?a:[],...r,"kinetic","potential","x","y","z"],c=n.t.map((u,d)=>[u,...n.base[d]??[],...t.flatMap(h=>n[h][d]),n.kinetic[d],n.potential[d],...n.tip[d]]);return[l,...c].map(u=>u.join(",")).join(`
`)+`
`}var ty=.3,ny=1e-5,iy=1001,[sy,rm]=[20,1e-5],om="the arm is singular there, and its joints have no finite velocities and accelerations along the line",ry="choose another start or target, or let each joint move by itself",Gu=(n,e)=>n.reduce((t,i,s)=>t+i*e[s],0),Bl=({size:n,hasRotation:e},t)=>(e?t:t.slice(0,3)).map((i,s)=>s<3?i/n:i),Hu=(n,e)=>da(n,e).columns.map(t=>Bl(n,t));function oy(n){let e=Ou(2),t=[0,1,2].map(()=>{let i=Pl(Hu(n,n.ranges.map(([s,r])=>s+(r-s)*e())));return i.filter(({value:s})=>s>1e-6*i[0].value).length});return Math.max(...t)}function ay(n,{from:e,duration:t,profile:i}){let{frame:s}=da(n,e),r=At(n.target.o,s.o),o=Ll(s,n.target),a=n.hasRotation?2*Math.asin(Math.min(1,Ot(o)/2)):0,l=On(o),c=Bl(n,[...r,...be(l,a)]);return{isStill:Ot(r)<=yr&&a<=yr,at(u){let[d,h,m]=Nu[i](u),g=p=>mr(p,l,a*d),_={x:g(s.x),y:g(s.y),z:g(s.z),o:Oe(s.o,be(r,d))},f=p=>c.map(v=>v*p);return{s:d,target:_,velocity:f(h/t),acceleration:f(m/t**2)}}}}function ly(n,e,t,i){let[s,r]=[i,null];for(let o=0;o<sy;o++){let{frame:a,columns:l}=da(n,s),[c,u]=[At(t.o,a.o),n.hasRotation?Ll(a,t):[0,0,0]],d=Math.max(Ot(c),Ot(u));if(r&&r.error<=yr&&!(d<r.error/2))return r.q;(!r||d<r.error)&&(r={q:s,error:d});let h=Pl(l.map(g=>Bl(n,g))).slice(0,e);if(!(h[e-1].value>0))break;let m=ro(h,"u","v",Bl(n,[...c,...u]));s=s.map((g,_)=>g+m[_])}return r.error<=yr?r.q:null}function cy(n,e,t,{velocity:i,acceleration:s}){let r=ro(e,"u","v",i),o=Math.max(...r.map(Math.abs));if(o===0)return{qd:r,qdd:ro(e,"u","v",s)};let[a,l]=[-1,1].map(_=>Hu(n,t.map((f,p)=>f+_*rm*r[p]/o))),c=l.map((_,f)=>_.map((p,v)=>(p-a[f][v])*o/(2*rm))),u=s.map((_,f)=>_-r.reduce((p,v,P)=>p+v*c[P][f],0)),d=ro(e,"v","u",r),h=c.map(_=>Gu(_,d)),m=e.map(({v:_})=>Gu(_,h)),g=h.map((_,f)=>_-e.reduce((p,{v},P)=>p+m[P]*v[f],0));return{qd:r,qdd:ro(e,"u","v",u).map((_,f)=>_+g[f])}}function hy(n){let e=n.map(i=>[...i]),t=1;for(let i=0;i<e.length;i++){let s=e.slice(i).reduce((r,o,a)=>Math.abs(o[i])>Math.abs(e[r][i])?i+a:r,i);s!==i&&([e[i],e[s],t]=[e[s],e[i],-t]),e[i][i]<0&&(t=-t);for(let r=i+1;r<e.length;r++)e[r]=e[r].map((o,a)=>o-e[r][i]/e[i][i]*e[i][a])}return t<0}function uy({joints:n,limits:e,size:t},i,{q:s,triples:r,columns:o},a){if(r[a-1].value<=ny*r[0].value)return om;let l=e.findIndex((d,h)=>d&&(s[h]<d[0]-1e-9||s[h]>d[1]+1e-9));if(l>=0)return`joint \`${n[l].name}\` would pass its limit`;if(!i)return null;if(s.some((d,h)=>Math.abs(i.q[h]-d)>ty*(n[h].type==="revolute"?1:t)))return"the line passes a singular pose so near that joints would have to jump";let u=i.triples.map(({v:d})=>o[0].map((h,m)=>o.reduce((g,_,f)=>g+d[f]*_[m],0)));return hy(u.map(d=>i.triples.map(({u:h})=>Gu(h,d))))?om:null}function am(n,e,t){let{from:i,duration:s,base:r}=t,o=Math.min(Fl(s),iy),a=s/(o-1),l=oy(e),c=ay(e,t),u=(m,g)=>{let _=c.at(m),f=c.isStill?i:ly(e,l,_.target,g);if(!f)return{s:_.s,reason:"the line leaves what the arm reaches, or meets a singular pose"};let p=Hu(e,f),v=Pl(p).slice(0,l),P=f.map(()=>0);return{s:_.s,q:f,columns:p,triples:v,...c.isStill?{qd:P,qdd:P}:cy(e,v,f,_)}},d={t:[],base:[],q:[],qd:[],qdd:[],ended:null},h=null;for(let m=0;m<o;m++){let g=h?h.q.map((p,v)=>p+a*(h.qd[v]+a/2*h.qdd[v])):i,_=u(m/(o-1),g),f=_.reason??(c.isStill?null:uy(e,h,_,l));if(f){let p=m===0?"at its start":`at ${Number((100*_.s).toPrecision(3))} % of the line`;if(d.ended={t:m*a,reason:`${p} ${f}; ${ry}`},m>0)break;let v=i.map(()=>NaN);Object.assign(_,{q:i,qd:v.map(()=>0),qdd:v})}d.t.push(m*a),d.base.push(r);for(let p of["q","qd","qdd"])d[p].push(_[p]);if(h=_,f)break}return dy(n,d,t,(m,g)=>u(m/s,g))}function dy(n,e,{base:t,key:i},s){let r=t?[0,0,0,0,0,0]:[],o=({q:d,qd:h,qdd:m})=>{let[g,_]=[h,m].map(f=>[...r,...f]);return{base:t,q:d,qd:g,qdd:_,tau:n.inverse_dynamics(t,d,g,_)}},a=e.q.map((d,h)=>o({q:d,qd:e.qd[h],qdd:e.qdd[h]})),l={...e,...Object.fromEntries(["qd","qdd","tau"].map(d=>[d,a.map(h=>h[d])]))},c=l.t[l.t.length-1];return Ol(n,{...l,duration:c,at:d=>{let h=Vu(l,d);if(l.t.includes(d)||l.t.length<2)return h;let m=s(d,h.q);return m.reason?h:o(m)}},{key:i})}var hm=n=>typeof n=="number"?[n]:n&&typeof n=="object"?Object.values(n).flatMap(hm):[];function lm([n,e,t,i,s,r],o){return[[[n,e,t],o],[[n*e-i*i,e*t-s*s,n*t-r*r],o**2],[[n*(e*t-s*s)-i*(i*t-s*r)+r*(i*s-e*r)],o**3]].every(([l,c])=>l.every(u=>u>=-1e-9*c))}function fy([n,e,t,i,s,r]){let o=Math.max(...[n,e,t,i,s,r].map(Math.abs));if([n,e,t].filter(c=>c!==0).length<2&&Math.min(n,e,t)>=0&&i===0&&s===0&&r===0)return null;let a=(n+e+t)/2;return lm([n,e,t,i,s,r],o)&&lm([a-n,a-e,a-t,-i,-s,-r],o)?null:"no body has this inertia tensor"}function cm(n){if(hm(n).some(t=>!Number.isFinite(t)))return"division by zero, or a number that is too large";let e=[[n.mass,"a mass"],[n.motorInertia,"a motor's inertia"],[n.viscous,"a friction coefficient"],[Math.min(...n.coulomb??[]),"a friction torque or force"],[n.stribeck?.friction,"a friction torque or force"],[n.spring?.stiffness,"a spring's stiffness"]].find(([t])=>t<0);return e?`${e[1]} cannot be negative`:n.motorInertia>0&&n.gearRatio===0?"a gear ratio of zero: a motor with inertia turns with its joint":n.stribeck&&!(n.stribeck.velocity>0)?"a Stribeck velocity is above zero":fy(n.inertia)}function um(n,e){let t=({rows:s,tool:r,base:o,floating:a,gravity:l})=>[...s,r,a,o&&{inertia:[0,0,0,0,0,0],base:o},{inertia:[0,0,0,0,0,0],gravity:l}],i=t(e);for(let[s,r]of t(n).entries()){let o=r&&cm(r);if(o&&o!==cm(i[s]))return r.name?`\`${r.name}\`: ${o}`:o}return null}function dm(){let n=new Map;return{on(e,t){for(let i of e.split(" "))n.set(i,[...n.get(i)??[],t])},tell(e){(n.get(e)??[]).forEach(t=>t())}}}var py=30;function my(n,e){return n.limits?n.limits:n.type==="revolute"?[-Math.PI,Math.PI]:[-e,e]}function fm([n,e]){return n<=0&&e>=0?0:(n+e)/2}var pm=[0,0,0,.1,1.5,.3],mm=[60,40,-50,30,70,-40];function gy(n,{type:e,joint:t},[i,s]){let r=mm[t%mm.length],o=e==="revolute"?r*Math.PI/180:(s-i)*r/240,[a,l]=[n+o,n-o],c=u=>u>=i&&u<=s;return c(a)?a:c(l)?l:o>0?s:i}function gm(n,e,t){let{on:i,tell:s}=dm(),r=Object.fromEntries(t.fields.map(({name:M,value:x})=>[M,x])),o=n(r),a=o.floating!==null,l=kp(e,r,a),c=o.rows.filter(M=>M.type==="prismatic"&&M.joint!==null).reduce((M,x)=>M+(x.limits?Math.max(...x.limits.map(Math.abs)):0),0),u=Op(o,c),d=o.rows.filter(M=>M.joint!==null),h=d.map(M=>my(M,u)),m=[...a?eo:[],...d],g=m.map(()=>0),_=t.from??h.map(fm),f={mode:"motion",pose:[...t.pose??[0,0,0,0,0,0]],q:[..._],qd:[...t.velocity??(a?[...pm,...g.slice(pm.length)]:g)],qdd:[...g],end:t.to??_.map((M,x)=>gy(M,d[x],h[x])),torque:[...g],target:null,hasRotation:!0,path:"joints",reached:{found:[],chosen:-1,missing:null},isDragged:!1,profile:"cycloidal",law:"none",hasFriction:!0,duration:t.duration,t:0,isPlaying:!1,isRepeated:!1,speed:1,selected:o.rows.indexOf(d[0]),tip:0,show:{parameters:"selected",frames:!1,axes:!1,masses:!1,trace:!0,names:!1,isFollowed:!0}},p={on:i,tell:s,state:f,first:t,fields:r,equations:l,table:o,size:u,joints:d,freedoms:m,ofBase:m.length-d.length,ranges:h,trajectory:null,units:bu(!0),now(){if(f.mode==="pose"){let{q:M,qd:x,qdd:y}=f,L=p.start();return{base:L,q:M,qd:x,qdd:y,tau:l.inverse_dynamics(L,M,x,y)}}return p.trajectory.at(f.t)},start:()=>a?Tp(f.pose):null,tip:()=>o.tips[f.tip],evaluated:()=>zp(l,p.now(),p.tip()),frames(){let{base:M,q:x}=p.now();return Ii(p.table,x,M)},setTime(M){let x=p.trajectory?.duration??0;f.t=Math.min(Math.max(M,0),x),s("time")},play(M){p.trajectory&&(f.isPlaying=M,M&&f.t>=p.trajectory.duration&&p.setTime(0),s("play"))},problem(){let{hasRotation:M,tip:x,target:y}=f,[L,R,I,...U]=y,k=es(zs,{xyz:[L,R,I],rpy:U}),E=d.map(N=>N.limits);return{table:p.table,base:p.start(),tip:x,target:k,hasRotation:M,limits:E,ranges:h,joints:d,size:u}},seek(M=!1){v(M,!1),f.isPlaying=!1,p.recompute(),p.setTime(p.trajectory.duration),s("play")},choose(M,x=!1){let{found:y}=f.reached;x?ua(p.problem(),y[M],h.map(fm)).forEach((L,R)=>f.q[R]=L):f.end=[...y[M]],p.changed()},placeTarget(){let{tips:M}=Ii(p.table,f.end,p.start()),{x,y,z:L,o:R}=M[f.tip];f.hasRotation=Wp(p.table,f.tip)>=6,f.target=[...R,...Qr([0,1,2].map(I=>[x[I],y[I],L[I]]))]},setMode(M){f.mode=M,M==="reach"&&(p.placeTarget(),p.seek()),f.isPlaying=!1,f.t=0,M!=="reach"&&p.recompute(),s("mode"),s("time"),s("play")},changed(){f.isPlaying=!1,f.t=0,s("play"),p.ask()},setFields(M){let x=n({...r,...M}),y=um(x,o);return y||(Object.assign(r,M),p.table=x,s("fields"),f.mode==="reach"?p.seek():p.changed(),null)},setUnits(M){p.units=bu(M),s("units")},select(M){f.selected=M,s("selection")},setTip(M){f.tip=M,f.mode==="reach"?(p.placeTarget(),p.seek()):p.recompute(),s("tip")},setShown(M){Object.assign(f.show,M),s("show")},recompute(){let M=performance.now(),{q:x,qd:y,end:L,torque:R,profile:I,law:U,hasFriction:k,duration:E}=f,{table:N}=p,z=p.start(),{key:O}=p.tip(),X=f.mode==="reach";p.trajectory=X&&f.path==="line"&&!f.isDragged?am(l,p.problem(),{base:z,from:[...x],duration:E,profile:I,key:O}):f.mode==="motion"||X?nm(l,{base:z,from:[...x],to:[...L],duration:E,profile:I,key:O}):f.mode==="free"?im(l,{table:N,law:U,hasFriction:k,duration:E,key:O,base:z,q:[...x],qd:[...y],torque:[...R]}):null,b=performance.now()-M,C=void 0,X&&P(),s("trajectory"),s("time")},isStale:()=>C!==void 0,ask(){clearTimeout(C),C=setTimeout(()=>{f.mode==="reach"&&v(!1,!0),p.recompute()},b>py||f.mode==="reach"?160:0)}};function v(M,x){let y=p.problem(),{q:L,end:R}=f;if(f.isDragged=M,M){let{q:E,isReached:N,...z}=Zp(y,R);f.end=ua(y,E,L),f.reached={found:N?[f.end]:[],chosen:-1,missing:N?null:z};return}let{found:I,missing:U}=jp(y,L),k=x?I.find(E=>Dl(y,E,R)):void 0;f.reached={found:I,chosen:-1,missing:U},f.end=[...k??I[0]??U.q]}function P(){let{ended:M,q:x}=p.trajectory,{reached:y}=f;y.chosen=M?-1:y.found.findIndex(L=>Dl(p.problem(),L,x[x.length-1])),s("reached")}let[b,C]=[0,void 0];return p.recompute(),p}var _y="uplot",xy="u-hz",yy="u-vt",vy="u-title",Sy="u-wrap",My="u-under",by="u-over",wy="u-axis",Mr="u-off",Ey="u-select",Ty="u-cursor-x",Ay="u-cursor-y",Ry="u-cursor-pt",Cy="u-legend",Py="u-live",Iy="u-inline",Ly="u-series",Dy="u-marker",_m="u-label",Ny="u-value",ma="width",ga="height";var xm="bottom",ao="left",Wu="right",ad="#000",ym=ad+"0",qu="mousemove",vm="mousedown",Xu="mouseup",Sm="mouseenter",Mm="mouseleave",bm="dblclick",Uy="resize",Fy="scroll",wm="change",Hl="dppxchange",ld="--",mo=typeof window<"u",Ju=mo?document:null,co=mo?window:null,Oy=mo?navigator:null,Rt,kl;function Ku(){let n=devicePixelRatio;Rt!=n&&(Rt=n,kl&&ed(wm,kl,Ku),kl=matchMedia(`(min-resolution: ${Rt-.001}dppx) and (max-resolution: ${Rt+.001}dppx)`),br(wm,kl,Ku),co.dispatchEvent(new CustomEvent(Hl)))}function ui(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Qu(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function $t(n,e,t){n.style[e]=t+"px"}function Li(n,e,t,i){let s=Ju.createElement(n);return e!=null&&ui(s,e),t?.insertBefore(s,i),s}function Mi(n,e){return Li("div",n,e)}var Em=new WeakMap;function ts(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=Em.get(n);r!=o&&(n.style.transform=r,Em.set(n,r),e<0||t<0||e>i||t>s?ui(n,Mr):Qu(n,Mr))}var Tm=new WeakMap;function Am(n,e,t){let i=e+t,s=Tm.get(n);i!=s&&(Tm.set(n,i),n.style.background=e,n.style.borderColor=t)}var Rm=new WeakMap;function Cm(n,e,t,i){let s=e+""+t,r=Rm.get(n);s!=r&&(Rm.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var cd={passive:!0},By={...cd,capture:!0};function br(n,e,t,i){e.addEventListener(n,t,i?By:cd)}function ed(n,e,t,i){e.removeEventListener(n,t,cd)}mo&&Ku();function Di(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:di((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function ig(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var sg=n=>n!=null,rg=n=>n!=null&&n>0,Xl=ig(sg),ky=ig(rg);function zy(n,e,t,i=0,s=!1){let r=s?ky:Xl,o=s?rg:sg;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Vt,l??-Vt]}function Yl(n,e,t,i){let s=Lm(n),r=Lm(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?xs:og,a=s==1?di:bi,l=r==1?bi:di,c=a(o(Sn(n))),u=l(o(Sn(e))),d=ho(t,c),h=ho(t,u);return t==10&&(c<0&&(d=Gt(d,-c)),u<0&&(h=Gt(h,-u))),i||t==2?(n=d*s,e=h*r):(n=hg(n,d),e=$l(e,h)),[n,e]}function hd(n,e,t,i){let s=Yl(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var ud=.1,Pm={mode:3,pad:ud},xa={pad:0,soft:null,mode:0},Vy={min:xa,max:xa};function Wl(n,e,t,i){return Zl(t)?Im(n,e,t):(xa.pad=t,xa.soft=i?0:null,xa.mode=i?3:0,Im(n,e,Vy))}function Et(n,e){return n??e}function Gy(n,e,t){for(e=Et(e,0),t=Et(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function Im(n,e,t){let i=t.min,s=t.max,r=Et(i.pad,0),o=Et(s.pad,0),a=Et(i.hard,-Vt),l=Et(s.hard,Vt),c=Et(i.soft,Vt),u=Et(s.soft,-Vt),d=Et(i.mode,0),h=Et(s.mode,0),m=e-n,g=xs(m),_=Yn(Sn(n),Sn(e)),f=xs(_),p=Sn(f-g);(m<1e-24||p>10)&&(m=0,(n==0||e==0)&&(m=1e-24,d==2&&c!=Vt&&(r=0),h==2&&u!=-Vt&&(o=0)));let v=m||_||1e3,P=xs(v),b=ho(10,di(P)),C=v*(m==0?n==0?.1:1:r),M=Gt(hg(n-C,b/10),24),x=n>=c&&(d==1||d==3&&M<=c||d==2&&M>=c)?c:Vt,y=Yn(a,M<x&&n>=x?x:Ni(x,M)),L=v*(m==0?e==0?.1:1:o),R=Gt($l(e+L,b/10),24),I=e<=u&&(h==1||h==3&&R>=u||h==2&&R<=u)?u:-Vt,U=Ni(l,R>I&&e<=I?I:Yn(I,R));return y==U&&y==0&&(U=100),[y,U]}var Hy=new Intl.NumberFormat(mo?Oy.language:"en-US"),dd=n=>Hy.format(n),fi=Math,Gl=fi.PI,Sn=fi.abs,di=fi.floor,vn=fi.round,bi=fi.ceil,Ni=fi.min,Yn=fi.max,ho=fi.pow,Lm=fi.sign,xs=fi.log10,og=fi.log2,Wy=(n,e=1)=>fi.sinh(n)*e,Yu=(n,e=1)=>fi.asinh(n/e),Vt=1/0;function Dm(n){return(xs((n^n>>31)-(n>>31))|0)+1}function td(n,e,t){return Ni(Yn(n,e),t)}function ag(n){return typeof n=="function"}function vt(n){return ag(n)?n:()=>n}var qy=()=>{},lg=n=>n,cg=(n,e)=>e,Xy=n=>null,Nm=n=>!0,Um=(n,e)=>n==e,Yy=/\.\d*?(?=9{6,}|0{6,})/gm,wr=n=>{if(dg(n)||Gs.has(n))return n;let e=`${n}`,t=e.match(Yy);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${wr(s)}e${r}`}return Gt(n,i)};function vr(n,e){return wr(Gt(wr(n/e))*e)}function $l(n,e){return wr(bi(wr(n/e))*e)}function hg(n,e){return wr(di(wr(n/e))*e)}function Gt(n,e=0){if(dg(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return vn(i)/t}var Gs=new Map;function ug(n){return((""+n).split(".")[1]||"").length}function va(n,e,t,i){let s=[],r=i.map(ug);for(let o=e;o<t;o++){let a=Sn(o),l=Gt(ho(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,d=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?u:Gt(u,d);s.push(h),Gs.set(h,d)}}return s}var ya={},fd=[],uo=[null,null],Vs=Array.isArray,dg=Number.isInteger,$y=n=>n===void 0;function Fm(n){return typeof n=="string"}function Zl(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function Zy(n){return n!=null&&typeof n=="object"}var jy=Object.getPrototypeOf(Uint8Array),fg="__proto__";function fo(n,e=Zl){let t;if(Vs(n)){let i=n.find(s=>s!=null);if(Vs(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=fo(n[s],e)}else t=n.slice()}else if(n instanceof jy)t=n.slice();else if(e(n)){t={};for(let i in n)i!=fg&&(t[i]=fo(n[i],e))}else t=n;return t}function mn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=fg&&(Zl(n[s])?mn(n[s],fo(i[s])):n[s]=fo(i[s]))}return n}var Jy=0,Ky=1,Qy=2;function ev(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function tv(n,e){if(sv(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return rv(o[0])||(o=iv(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],d=Array(s).fill(void 0),h=e?e[o][c]:Ky,m=[];for(let g=0;g<u.length;g++){let _=u[g],f=r.get(l[g]);_===null?h!=Jy&&(d[f]=_,h==Qy&&m.push(f)):d[f]=_}ev(d,m,s),i.push(d)}}return i}var nv=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function iv(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function sv(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function rv(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Yn(1,di((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var pg=["January","February","March","April","May","June","July","August","September","October","November","December"],mg=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function gg(n){return n.slice(0,3)}var ov=mg.map(gg),av=pg.map(gg),lv={MMMM:pg,MMM:av,WWWW:mg,WWW:ov};function pa(n){return(n<10?"0":"")+n}function cv(n){return(n<10?"00":n<100?"0":"")+n}var hv={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>pa(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>pa(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>pa(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>pa(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>pa(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>cv(n.getMilliseconds())};function pd(n,e){e=e||lv;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?hv[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var uv=new Intl.DateTimeFormat().resolvedOptions().timeZone;function dv(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==uv?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var _g=n=>n%1==0,ql=[1,2,2.5,5],fv=va(10,-32,0,ql),xg=va(10,0,32,ql),pv=xg.filter(_g),Sr=fv.concat(xg),md=`
`,yg="{YYYY}",Om=md+yg,vg="{M}/{D}",_a=md+vg,zl=_a+"/{YY}",Sg="{aa}",mv="{h}:{mm}",lo=mv+Sg,Bm=md+lo,km=":{ss}",It=null;function Mg(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?va(10,0,3,ql).filter(_g):va(10,-3,0,ql)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,yg,It,It,It,It,It,It,1],[s*28,"{MMM}",Om,It,It,It,It,It,1],[s,vg,Om,It,It,It,It,It,1],[i,"{h}"+Sg,zl,It,_a,It,It,It,1],[t,lo,zl,It,_a,It,It,It,1],[e,km,zl+" "+lo,It,_a+" "+lo,It,Bm,It,1],[n,km+".{fff}",zl+" "+lo,It,_a+" "+lo,It,Bm,It,1]];function u(d){return(h,m,g,_,f,p)=>{let v=[],P=f>=o,b=f>=r&&f<o,C=d(g),M=Gt(C*n,3),x=$u(C.getFullYear(),P?0:C.getMonth(),b||P?1:C.getDate()),y=Gt(x*n,3);if(b||P){let L=b?f/r:0,R=P?f/o:0,I=M==y?M:Gt($u(x.getFullYear()+R,x.getMonth()+L,1)*n,3),U=new Date(vn(I/n)),k=U.getFullYear(),E=U.getMonth();for(let N=0;I<=_;N++){let z=$u(k+R*N,E+L*N,1),O=z-d(Gt(z*n,3));I=Gt((+z+O)*n,3),I<=_&&v.push(I)}}else{let L=f>=s?s:f,R=di(g)-di(M),I=y+R+$l(M-y,L);v.push(I);let U=d(I),k=U.getHours()+U.getMinutes()/t+U.getSeconds()/i,E=f/i,N=h.axes[m]._space,z=p/N;for(;I=Gt(I+f,n==1?0:3),!(I>_);)if(E>1){let O=di(Gt(k+E,6))%24,Z=d(I).getHours()-O;Z>1&&(Z=-1),I-=Z*i,k=(k+E)%24;let te=v[v.length-1];Gt((I-te)/f,3)*z>=.7&&v.push(I)}else v.push(I)}return v}}return[l,c,u]}var[gv,_v,xv]=Mg(1),[yv,vv,Sv]=Mg(.001);va(2,-53,53,[1]);function zm(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function Vm(n,e){return(t,i,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,u,d,h,m;return i.map(g=>{let _=n(g),f=_.getFullYear(),p=_.getMonth(),v=_.getDate(),P=_.getHours(),b=_.getMinutes(),C=_.getSeconds(),M=f!=l&&a[2]||p!=c&&a[3]||v!=u&&a[4]||P!=d&&a[5]||b!=h&&a[6]||C!=m&&a[7]||a[1];return l=f,c=p,u=v,d=P,h=b,m=C,M(_)})}}function Mv(n,e){let t=pd(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function $u(n,e,t){return new Date(n,e,t)}function Gm(n,e){return e(n)}var bv="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Hm(n,e){return(t,i,s,r)=>r==null?ld:e(n(i))}function wv(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function Ev(n,e){return n.series[e].fill(n,e)}var Tv={show:!0,live:!0,isolate:!1,mount:qy,markers:{show:!0,width:2,stroke:wv,fill:Ev,dash:"solid"},idx:null,idxs:null,values:[]};function Av(n,e){let t=n.cursor.points,i=Mi(),s=t.size(n,e);$t(i,ma,s),$t(i,ga,s);let r=s/-2;$t(i,"marginLeft",r),$t(i,"marginTop",r);let o=t.width(n,e,s);return o&&$t(i,"borderWidth",o),i}function Rv(n,e){let t=n.series[e].points;return t._fill||t._stroke}function Cv(n,e){let t=n.series[e].points;return t._stroke||t._fill}function Pv(n,e){return n.series[e].points.size}var Zu=[0,0];function Iv(n,e,t){return Zu[0]=e,Zu[1]=t,Zu}function Vl(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function ju(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var Lv={show:!0,x:!0,y:!0,lock:!1,move:Iv,points:{one:!1,show:Av,size:Pv,width:0,stroke:Cv,fill:Rv},bind:{mousedown:Vl,mouseup:Vl,click:Vl,dblclick:Vl,mousemove:ju,mouseleave:ju,mouseenter:ju},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},bg={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},gd=mn({},bg,{filter:cg}),wg=mn({},gd,{size:10}),Eg=mn({},bg,{show:!1}),_d='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Tg="bold "+_d,Ag=1.5,Wm={show:!0,scale:"x",stroke:ad,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Tg,side:2,grid:gd,ticks:wg,border:Eg,font:_d,lineGap:Ag,rotate:0},Dv="Value",Nv="Time",qm={show:!0,scale:"x",auto:!1,sorted:1,min:Vt,max:-Vt,idxs:[]};function Uv(n,e,t,i,s){return e.map(r=>r==null?"":dd(r))}function Fv(n,e,t,i,s,r,o){let a=[],l=Gs.get(s)||0;t=o?t:Gt($l(t,s),l);for(let c=t;c<=i;c=Gt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function nd(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?xs:og,u=di(c(t));s=ho(l,u),l==10&&(s=Sr[Di(s,Sr)]);let d=t,h=s*l;l==10&&(h=Sr[Di(h,Sr)]);do a.push(d),d=d+s,l==10&&!Gs.has(d)&&(d=Gt(d,Gs.get(s))),d>=h&&(s=d,h=s*l,l==10&&(h=Sr[Di(h,Sr)]));while(d<=i);return a}function Ov(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?nd(n,e,Yn(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?nd(n,e,Yn(l,-i),-t,s):[l]).reverse().map(h=>-h).concat(u,c)}var Rg=/./,Bv=/[12357]/,kv=/[125]/,Xm=/1/,id=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function zv(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),d=l(9,o)-u>=c?Rg:l(7,o)-u>=c?Bv:l(5,o)-u>=c?kv:Xm;if(d==Xm){let h=Sn(l(1,o)-u);if(h<c)return id(e.slice().reverse(),a.distr,d,bi(c/h)).reverse()}return id(e,a.distr,d,1)}function Vv(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=Sn(l(1,o)-l(2,o));return c<a?id(e.slice().reverse(),3,Rg,bi(a/c)).reverse():e}function Gv(n,e,t,i){return i==null?ld:e==null?"":dd(e)}var Ym={show:!0,scale:"y",stroke:ad,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Tg,side:3,grid:gd,ticks:wg,border:Eg,font:_d,lineGap:Ag,rotate:0};function Hv(n,e){let t=3+(n||1)*2;return Gt(t*e,3)}function Wv(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=Sn(o-r),l=n.series[e],c=a/(l.points.space*Rt);return i[1]-i[0]<=c}var $m={scale:null,auto:!0,sorted:0,min:Vt,max:-Vt},Cg=(n,e,t,i,s)=>s,Zm={show:!0,auto:!0,sorted:0,gaps:Cg,alpha:1,facets:[mn({},$m,{scale:"x"}),mn({},$m,{scale:"y"})]},jm={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Cg,alpha:1,points:{show:Wv,filter:null},values:null,min:Vt,max:-Vt,idxs:[],path:null,clip:null};function qv(n,e,t,i,s){return t/10}var Pg={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Xv=mn({},Pg,{time:!1,ori:1}),Jm={};function Ig(n,e){let t=Jm[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(Jm[n]=t)),t}var po=1,sd=2;function Er(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],d=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,m=a.top,g=a.width,_=a.height,f=n.valToPosH,p=n.valToPosV;return u.ori==0?t(s,l,c,u,d,f,p,h,m,g,_,Jl,go,Ql,Dg,Ug):t(s,l,c,u,d,p,f,m,h,_,g,Kl,_o,vd,Ng,Fg)}function xd(n,e){let t=0,i=0,s=Et(n.bands,fd);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function Yv(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function ys(n,e,t,i,s,r){return Er(n,e,(o,a,l,c,u,d,h,m,g,_,f)=>{let p=o.pxRound,v=c.dir*(c.ori==0?1:-1),P=c.ori==0?go:_o,b,C;v==1?(b=t,C=i):(b=i,C=t);let M=p(d(a[b],c,_,m)),x=p(h(l[b],u,f,g)),y=p(d(a[C],c,_,m)),L=p(h(r==1?u.max:u.min,u,f,g)),R=new Path2D(s);return P(R,y,L),P(R,M,L),P(R,M,x),R})}function jl(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?Ql:vd,l=t;for(let d=0;d<n.length;d++){let h=n[d];if(h[1]>h[0]){let m=h[0]-l;m>0&&a(o,l,i,m,i+r),l=h[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function $v(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function yd(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let d=c,h=c;if(s==1)for(;++c<=i&&e[c]===null;)h=c;else for(;--c>=t&&e[c]===null;)h=c;let m=r(n[d]),g=h==d?m:r(n[h]),_=d-s;m=o<=0&&_>=0&&_<l?r(n[_]):m;let p=h+s;g=o>=0&&p>=0&&p<l?r(n[p]):g,g>=m&&a.push([m,g])}return a}function Km(n){return n==0?lg:n==1?vn:e=>vr(e,n)}function Lg(n){let e=n==0?Jl:Kl,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Ni(c,a/2,l/2),u=Ni(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Jl=(n,e,t)=>{n.moveTo(e,t)},Kl=(n,e,t)=>{n.moveTo(t,e)},go=(n,e,t)=>{n.lineTo(e,t)},_o=(n,e,t)=>{n.lineTo(t,e)},Ql=Lg(0),vd=Lg(1),Dg=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},Ng=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},Ug=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},Fg=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function Og(n){return(e,t,i,s,r)=>Er(e,t,(o,a,l,c,u,d,h,m,g,_,f)=>{let{pxRound:p,points:v}=o,P,b;c.ori==0?(P=Jl,b=Dg):(P=Kl,b=Ng);let C=Gt(v.width*Rt,3),M=(v.size-v.width)/2*Rt,x=Gt(M*2,3),y=new Path2D,L=new Path2D,{left:R,top:I,width:U,height:k}=e.bbox;Ql(L,R-x,I-x,U+x*2,k+x*2);let E=N=>{if(l[N]!=null){let z=p(d(a[N],c,_,m)),O=p(h(l[N],u,f,g));P(y,z+M,O),b(y,z,O,M,0,Gl*2)}};if(r)r.forEach(E);else for(let N=i;N<=s;N++)E(N);return{stroke:C>0?y:null,fill:y,clip:L,flags:po|sd}})}function Bg(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var Zv=Bg(go),jv=Bg(_o);function kg(n){let e=Et(n?.alignGaps,0);return(t,i,s,r)=>Er(t,i,(o,a,l,c,u,d,h,m,g,_,f)=>{[s,r]=Xl(l,s,r);let p=o.pxRound,v=k=>p(d(k,c,_,m)),P=k=>p(h(k,u,f,g)),b,C;c.ori==0?(b=go,C=Zv):(b=_o,C=jv);let M=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:po},y=x.stroke,L=!1;if(r-s>=_*4){let k=he=>t.posToVal(he,c.key,!0),E=null,N=null,z,O,X,H=v(a[M==1?s:r]),Z=v(a[s]),te=v(a[r]),le=k(M==1?Z+1:te-1);for(let he=M==1?s:r;he>=s&&he<=r;he+=M){let Q=a[he],ge=(M==1?Q<le:Q>le)?H:v(Q),oe=l[he];ge==H?oe!=null?(O=oe,E==null?(b(y,ge,P(O)),z=E=N=O):O<E?E=O:O>N&&(N=O)):oe===null&&(L=!0):(E!=null&&C(y,H,P(E),P(N),P(z),P(O)),oe!=null?(O=oe,b(y,ge,P(O)),E=N=z=O):(E=N=null,oe===null&&(L=!0)),H=ge,le=k(H+M))}E!=null&&E!=N&&X!=H&&C(y,H,P(E),P(N),P(z),P(O))}else for(let k=M==1?s:r;k>=s&&k<=r;k+=M){let E=l[k];E===null?L=!0:E!=null&&b(y,v(a[k]),P(E))}let[I,U]=xd(t,i);if(o.fill!=null||I!=0){let k=x.fill=new Path2D(y),E=o.fillTo(t,i,o.min,o.max,I),N=P(E),z=v(a[s]),O=v(a[r]);M==-1&&([O,z]=[z,O]),b(k,O,N),b(k,z,N)}if(!o.spanGaps){let k=[];L&&k.push(...yd(a,l,s,r,M,v,e)),x.gaps=k=o.gaps(t,i,s,r,k),x.clip=jl(k,c.ori,m,g,_,f)}return U!=0&&(x.band=U==2?[ys(t,i,s,r,y,-1),ys(t,i,s,r,y,1)]:ys(t,i,s,r,y,U)),x})}function Jv(n){let e=Et(n.align,1),t=Et(n.ascDesc,!1),i=Et(n.alignGaps,0),s=Et(n.extend,!1);return(r,o,a,l)=>Er(r,o,(c,u,d,h,m,g,_,f,p,v,P)=>{[a,l]=Xl(d,a,l);let b=c.pxRound,{left:C,width:M}=r.bbox,x=Z=>b(g(Z,h,v,f)),y=Z=>b(_(Z,m,P,p)),L=h.ori==0?go:_o,R={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:po},I=R.stroke,U=h.dir*(h.ori==0?1:-1),k=y(d[U==1?a:l]),E=x(u[U==1?a:l]),N=E,z=E;s&&e==-1&&(z=C,L(I,z,k)),L(I,E,k);for(let Z=U==1?a:l;Z>=a&&Z<=l;Z+=U){let te=d[Z];if(te==null)continue;let le=x(u[Z]),he=y(te);e==1?L(I,le,k):L(I,N,he),L(I,le,he),k=he,N=le}let O=N;s&&e==1&&(O=C+M,L(I,O,k));let[X,H]=xd(r,o);if(c.fill!=null||X!=0){let Z=R.fill=new Path2D(I),te=c.fillTo(r,o,c.min,c.max,X),le=y(te);L(Z,O,le),L(Z,z,le)}if(!c.spanGaps){let Z=[];Z.push(...yd(u,d,a,l,U,x,i));let te=c.width*Rt/2,le=t||e==1?te:-te,he=t||e==-1?-te:te;Z.forEach(Q=>{Q[0]+=le,Q[1]+=he}),R.gaps=Z=c.gaps(r,o,a,l,Z),R.clip=jl(Z,h.ori,f,p,v,P)}return H!=0&&(R.band=H==2?[ys(r,o,a,l,I,-1),ys(r,o,a,l,I,1)]:ys(r,o,a,l,I,H)),R})}function Qm(n,e,t,i,s,r,o=Vt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=Sn(n[l]-n[a]);u<c&&(c=u,o=Sn(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function Kv(n){n=n||ya;let e=Et(n.size,[.6,Vt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=vt(s),o=1-e[0],a=Et(e[1],Vt),l=Et(e[2],1),c=Et(n.disp,ya),u=Et(n.each,m=>{}),{fill:d,stroke:h}=c;return(m,g,_,f)=>Er(m,g,(p,v,P,b,C,M,x,y,L,R,I)=>{let U=p.pxRound,k=t,E=i*Rt,N=a*Rt,z=l*Rt,O,X;b.ori==0?[O,X]=r(m,g):[X,O]=r(m,g);let H=b.dir*(b.ori==0?1:-1),Z=b.ori==0?Ql:vd,te=b.ori==0?u:(Pe,Je,lt,Ee,zt,We,Ze)=>{u(Pe,Je,lt,zt,Ee,Ze,We)},le=Et(m.bands,fd).find(Pe=>Pe.series[0]==g),he=le!=null?le.dir:0,Q=p.fillTo(m,g,p.min,p.max,he),me=U(x(Q,C,I,L)),ge,oe,de,Ne=R,Ye=U(p.width*Rt),Be=!1,st=null,at=null,$e=null,pt=null;d!=null&&(Ye==0||h!=null)&&(Be=!0,st=d.values(m,g,_,f),at=new Map,new Set(st).forEach(Pe=>{Pe!=null&&at.set(Pe,new Path2D)}),Ye>0&&($e=h.values(m,g,_,f),pt=new Map,new Set($e).forEach(Pe=>{Pe!=null&&pt.set(Pe,new Path2D)})));let{x0:Mt,size:jt}=c;if(Mt!=null&&jt!=null){k=1,v=Mt.values(m,g,_,f),Mt.unit==2&&(v=v.map(lt=>m.posToVal(y+lt*R,b.key,!0)));let Pe=jt.values(m,g,_,f);jt.unit==2?oe=Pe[0]*R:oe=M(Pe[0],b,R,y)-M(0,b,R,y),Ne=Qm(v,P,M,b,R,y,Ne),de=Ne-oe+E}else Ne=Qm(v,P,M,b,R,y,Ne),de=Ne*o+E,oe=Ne-de;de<1&&(de=0),Ye>=oe/2&&(Ye=0),de<5&&(U=lg);let Pt=de>0,rn=Ne-de-(Pt?Ye:0);oe=U(td(rn,z,N)),ge=(k==0?oe/2:k==H?0:oe)-k*H*((k==0?E/2:0)+(Pt?Ye/2:0));let bt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},xn=Be?null:new Path2D,Qt=null;if(le!=null)Qt=m.data[le.series[1]];else{let{y0:Pe,y1:Je}=c;Pe!=null&&Je!=null&&(P=Je.values(m,g,_,f),Qt=Pe.values(m,g,_,f))}let ln=O*oe,G=X*oe;for(let Pe=H==1?_:f;Pe>=_&&Pe<=f;Pe+=H){let Je=P[Pe];if(Je==null)continue;if(Qt!=null){let j=Qt[Pe]??0;if(Je-j==0)continue;me=x(j,C,I,L)}let lt=b.distr!=2||c!=null?v[Pe]:Pe,Ee=M(lt,b,R,y),zt=x(Et(Je,Q),C,I,L),We=U(Ee-ge),Ze=U(Yn(zt,me)),D=U(Ni(zt,me)),w=Ze-D;if(Je!=null){let j=Je<0?G:ln,pe=Je<0?ln:G;Be?(Ye>0&&$e[Pe]!=null&&Z(pt.get($e[Pe]),We,D+di(Ye/2),oe,Yn(0,w-Ye),j,pe),st[Pe]!=null&&Z(at.get(st[Pe]),We,D+di(Ye/2),oe,Yn(0,w-Ye),j,pe)):Z(xn,We,D+di(Ye/2),oe,Yn(0,w-Ye),j,pe),te(m,g,Pe,We-Ye/2,D,oe+Ye,w)}}return Ye>0?bt.stroke=Be?pt:xn:Be||(bt._fill=p.width==0?p._fill:p._stroke??p._fill,bt.width=0),bt.fill=Be?at:xn,bt})}function Qv(n,e){let t=Et(e?.alignGaps,0);return(i,s,r,o)=>Er(i,s,(a,l,c,u,d,h,m,g,_,f,p)=>{[r,o]=Xl(c,r,o);let v=a.pxRound,P=O=>v(h(O,u,f,g)),b=O=>v(m(O,d,p,_)),C,M,x;u.ori==0?(C=Jl,x=go,M=Ug):(C=Kl,x=_o,M=Fg);let y=u.dir*(u.ori==0?1:-1),L=P(l[y==1?r:o]),R=L,I=[],U=[];for(let O=y==1?r:o;O>=r&&O<=o;O+=y)if(c[O]!=null){let H=l[O],Z=P(H);I.push(R=Z),U.push(b(c[O]))}let k={stroke:n(I,U,C,x,M,v),fill:null,clip:null,band:null,gaps:null,flags:po},E=k.stroke,[N,z]=xd(i,s);if(a.fill!=null||N!=0){let O=k.fill=new Path2D(E),X=a.fillTo(i,s,a.min,a.max,N),H=b(X);x(O,R,H),x(O,L,H)}if(!a.spanGaps){let O=[];O.push(...yd(l,c,r,o,y,P,t)),k.gaps=O=a.gaps(i,s,r,o,O),k.clip=jl(O,u.ori,g,_,f,p)}return z!=0&&(k.band=z==2?[ys(i,s,r,o,E,-1),ys(i,s,r,o,E,1)]:ys(i,s,r,o,E,z)),k})}function eS(n){return Qv(tS,n)}function tS(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),d=Array(o-1);for(let h=0;h<o-1;h++)u[h]=e[h+1]-e[h],d[h]=n[h+1]-n[h],c[h]=u[h]/d[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(d[h-1]+d[h])/((2*d[h]+d[h-1])/c[h-1]+(d[h]+2*d[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+d[h]/3,e[h]+l[h]*d[h]/3,n[h+1]-d[h]/3,e[h+1]-l[h+1]*d[h]/3,n[h+1],e[h+1])}return a}var rd=new Set;function eg(){for(let n of rd)n.syncRect(!0)}mo&&(br(Uy,co,eg),br(Fy,co,eg,!0),br(Hl,co,()=>{In.pxRatio=Rt}));var nS=kg(),iS=Og();function tg(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>od(r,o,e,t))}function sS(n,e){return n.map((t,i)=>i==0?{}:mn({},e,t))}function od(n,e,t,i){return mn({},e==0?t:i,n)}function zg(n,e,t){return e==null?uo:[e,t]}var rS=zg;function oS(n,e,t){return e==null?uo:Wl(e,t,ud,!0)}function Vg(n,e,t,i){return e==null?uo:Yl(e,t,n.scales[i].log,!1)}var aS=Vg;function Gg(n,e,t,i){return e==null?uo:hd(e,t,n.scales[i].log,!1)}var lS=Gg;function cS(n,e,t,i,s){let r=Yn(Dm(n),Dm(e)),o=e-n,a=Di(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?Gs.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function ng(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=vn((t=+s)*Rt))+"px"),[n,e,t]}function hS(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Gt(e[2]*Rt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function In(n,e,t){let i={mode:Et(n.mode,1)},s=i.mode;function r(S,T,F,B){let $=T.valToPct(S);return B+F*(T.dir==-1?1-$:$)}function o(S,T,F,B){let $=T.valToPct(S);return B+F*(T.dir==-1?$:1-$)}function a(S,T,F,B){return T.ori==0?r(S,T,F,B):o(S,T,F,B)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Mi(_y);if(n.id!=null&&(c.id=n.id),ui(c,n.class),n.title){let S=Mi(vy,c);S.textContent=n.title}let u=Li("canvas"),d=i.ctx=u.getContext("2d"),h=Mi(Sy,c);br("click",h,S=>{S.target===g&&(qt!=$r||Jt!=Zr)&&Pn.click(i,S)},!0);let m=i.under=Mi(My,h);h.appendChild(u);let g=i.over=Mi(by,h);n=fo(n);let _=+Et(n.pxAlign,1),f=Km(_);(n.plugins||[]).forEach(S=>{S.opts&&(n=S.opts(i,n)||n)});let p=n.ms||.001,v=i.series=s==1?tg(n.series||[],qm,jm,!1):sS(n.series||[null],Zm),P=i.axes=tg(n.axes||[],Wm,Ym,!0),b=i.scales={},C=i.bands=n.bands||[];C.forEach(S=>{S.fill=vt(S.fill||null),S.dir=Et(S.dir,-1)});let M=s==2?v[1].facets[0].scale:v[0].scale,x={axes:ms,series:_t},y=(n.drawOrder||["axes","series"]).map(S=>x[S]);function L(S){let T=S.distr==3?F=>xs(F>0?F:S.clamp(i,F,S.min,S.max,S.key)):S.distr==4?F=>Yu(F,S.asinh):S.distr==100?F=>S.fwd(F):F=>F;return F=>{let B=T(F),{_min:$,_max:ee}=S,ue=ee-$;return(B-$)/ue}}function R(S){let T=b[S];if(T==null){let F=(n.scales||ya)[S]||ya;if(F.from!=null){R(F.from);let B=mn({},b[F.from],F,{key:S});B.valToPct=L(B),b[S]=B}else{T=b[S]=mn({},S==M?Pg:Xv,F),T.key=S;let B=T.time,$=T.range,ee=Vs($);if((S!=M||s==2&&!B)&&(ee&&($[0]==null||$[1]==null)&&($={min:$[0]==null?Pm:{mode:1,hard:$[0],soft:$[0]},max:$[1]==null?Pm:{mode:1,hard:$[1],soft:$[1]}},ee=!1),!ee&&Zl($))){let ue=$;$=(_e,Me,Ue)=>Me==null?uo:Wl(Me,Ue,ue)}T.range=vt($||(B?rS:S==M?T.distr==3?aS:T.distr==4?lS:zg:T.distr==3?Vg:T.distr==4?Gg:oS)),T.auto=vt(ee?!1:T.auto),T.clamp=vt(T.clamp||qv),T._min=T._max=null,T.valToPct=L(T)}}}R("x"),R("y"),s==1&&v.forEach(S=>{R(S.scale)}),P.forEach(S=>{R(S.scale)});for(let S in n.scales)R(S);let I=b[M],U=I.distr,k,E;I.ori==0?(ui(c,xy),k=r,E=o):(ui(c,yy),k=o,E=r);let N={};for(let S in b){let T=b[S];(T.min!=null||T.max!=null)&&(N[S]={min:T.min,max:T.max},T.min=T.max=null)}let z=n.tzDate||(S=>new Date(vn(S/p))),O=n.fmtDate||pd,X=p==1?xv(z):Sv(z),H=Vm(z,zm(p==1?_v:vv,O)),Z=Hm(z,Gm(bv,O)),te=[],le=i.legend=mn({},Tv,n.legend),he=i.cursor=mn({},Lv,{drag:{y:s==2}},n.cursor),Q=le.show,me=he.show,ge=le.markers;le.idxs=te,ge.width=vt(ge.width),ge.dash=vt(ge.dash),ge.stroke=vt(ge.stroke),ge.fill=vt(ge.fill);let oe,de,Ne,Ye=[],Be=[],st,at=!1,$e={};if(le.live){let S=v[1]?v[1].values:null;at=S!=null,st=at?S(i,1,0):{_:0};for(let T in st)$e[T]=ld}if(Q)if(oe=Li("table",Cy,c),Ne=Li("tbody",null,oe),le.mount(i,oe),at){de=Li("thead",null,oe,Ne);let S=Li("tr",null,de);Li("th",null,S);for(var pt in st)Li("th",_m,S).textContent=pt}else ui(oe,Iy),le.live&&ui(oe,Py);let Mt={show:!0},jt={show:!1};function Pt(S,T){if(T==0&&(at||!le.live||s==2))return uo;let F=[],B=Li("tr",Ly,Ne,Ne.childNodes[T]);ui(B,S.class),S.show||ui(B,Mr);let $=Li("th",null,B);if(ge.show){let _e=Mi(Dy,$);if(T>0){let Me=ge.width(i,T);Me&&(_e.style.border=Me+"px "+ge.dash(i,T)+" "+ge.stroke(i,T)),_e.style.background=ge.fill(i,T)}}let ee=Mi(_m,$);S.label instanceof HTMLElement?ee.appendChild(S.label):ee.textContent=S.label,T>0&&(ge.show||(ee.style.color=S.width>0?ge.stroke(i,T):ge.fill(i,T)),bt("click",$,_e=>{if(he._lock)return;et(_e);let Me=v.indexOf(S);if((_e.ctrlKey||_e.metaKey)!=le.isolate){let Ue=v.some((Fe,ze)=>ze>0&&ze!=Me&&Fe.show);v.forEach((Fe,ze)=>{ze>0&&Zi(ze,Ue?ze==Me?Mt:jt:Mt,!0,dn.setSeries)})}else Zi(Me,{show:!S.show},!0,dn.setSeries)},!1),tt&&bt(Sm,$,_e=>{he._lock||(et(_e),Zi(v.indexOf(S),Jr,!0,dn.setSeries))},!1));for(var ue in st){let _e=Li("td",Ny,B);_e.textContent="--",F.push(_e)}return[B,F]}let rn=new Map;function bt(S,T,F,B=!0){let $=rn.get(T)||{},ee=he.bind[S](i,T,F,B);ee&&(br(S,T,$[S]=ee),rn.set(T,$))}function xn(S,T,F){let B=rn.get(T)||{};for(let $ in B)(S==null||$==S)&&(ed($,T,B[$]),delete B[$]);S==null&&rn.delete(T)}let Qt=0,ln=0,G=0,Pe=0,Je=0,lt=0,Ee=Je,zt=lt,We=G,Ze=Pe,D=0,w=0,j=0,pe=0;i.bbox={};let ce=!1,ve=!1,Se=!1,ie=!1,re=!1,xe=!1;function V(S,T,F){(F||S!=i.width||T!=i.height)&&ae(S,T),dt(!1),Se=!0,ve=!0,Fn()}function ae(S,T){i.width=Qt=G=S,i.height=ln=Pe=T,Je=lt=0,we(),qe();let F=i.bbox;D=F.left=vr(Je*Rt,.5),w=F.top=vr(lt*Rt,.5),j=F.width=vr(G*Rt,.5),pe=F.height=vr(Pe*Rt,.5)}let se=3;function Te(){let S=!1,T=0;for(;!S;){T++;let F=qr(T),B=$i(T);S=T==se||F&&B,S||(ae(i.width,i.height),ve=!0)}}function ye({width:S,height:T}){V(S,T)}i.setSize=ye;function we(){let S=!1,T=!1,F=!1,B=!1;P.forEach(($,ee)=>{if($.show&&$._show){let{side:ue,_size:_e}=$,Me=ue%2,Ue=$.label!=null?$.labelSize:0,Fe=_e+Ue;Fe>0&&(Me?(G-=Fe,ue==3?(Je+=Fe,B=!0):F=!0):(Pe-=Fe,ue==0?(lt+=Fe,S=!0):T=!0))}}),Xi[0]=S,Xi[1]=F,Xi[2]=T,Xi[3]=B,G-=Ai[1]+Ai[3],Je+=Ai[3],Pe-=Ai[2]+Ai[0],lt+=Ai[0]}function qe(){let S=Je+G,T=lt+Pe,F=Je,B=lt;function $(ee,ue){switch(ee){case 1:return S+=ue,S-ue;case 2:return T+=ue,T-ue;case 3:return F-=ue,F+ue;case 0:return B-=ue,B+ue}}P.forEach((ee,ue)=>{if(ee.show&&ee._show){let _e=ee.side;ee._pos=$(_e,ee._size),ee.label!=null&&(ee._lpos=$(_e,ee.labelSize))}})}if(he.dataIdx==null){let S=he.hover,T=S.skip=new Set(S.skip??[]);T.add(void 0);let F=S.prox=vt(S.prox),B=S.bias??=0;he.dataIdx=($,ee,ue,_e)=>{if(ee==0)return ue;let Me=ue,Ue=F($,ee,ue,_e)??Vt,Fe=Ue>=0&&Ue<Vt,ze=I.ori==0?G:Pe,ot=he.left,Tt=e[0],wt=e[ee];if(T.has(wt[ue])){Me=null;let xt=null,Qe=null,Xe;if(B==0||B==-1)for(Xe=ue;xt==null&&Xe-- >0;)T.has(wt[Xe])||(xt=Xe);if(B==0||B==1)for(Xe=ue;Qe==null&&Xe++<wt.length;)T.has(wt[Xe])||(Qe=Xe);if(xt!=null||Qe!=null)if(Fe){let Yt=xt==null?-1/0:k(Tt[xt],I,ze,0),nn=Qe==null?1/0:k(Tt[Qe],I,ze,0),Rn=ot-Yt,kt=nn-ot;Rn<=kt?Rn<=Ue&&(Me=xt):kt<=Ue&&(Me=Qe)}else Me=Qe==null?xt:xt==null?Qe:ue-xt<=Qe-ue?xt:Qe}else Fe&&Sn(ot-k(Tt[ue],I,ze,0))>Ue&&(Me=null);return Me}}let et=S=>{he.event=S};he.idxs=te,he._lock=!1;let fe=he.points;fe.show=vt(fe.show),fe.size=vt(fe.size),fe.stroke=vt(fe.stroke),fe.width=vt(fe.width),fe.fill=vt(fe.fill);let Ve=i.focus=mn({},n.focus||{alpha:.3},he.focus),tt=Ve.prox>=0,Ce=tt&&fe.one,ut=[],Wt=[],Gn=[];function Ko(S,T){let F=fe.show(i,T);if(F instanceof HTMLElement)return ui(F,Ry),ui(F,S.class),ts(F,-10,-10,G,Pe),g.insertBefore(F,ut[T]),F}function Gr(S,T){if(s==1||T>0){let F=s==1&&b[S.scale].time,B=S.value;S.value=F?Fm(B)?Hm(z,Gm(B,O)):B||Z:B||Gv,S.label=S.label||(F?Nv:Dv)}if(Ce||T>0){S.width=S.width==null?1:S.width,S.paths=S.paths||nS||Xy,S.fillTo=vt(S.fillTo||Yv),S.pxAlign=+Et(S.pxAlign,_),S.pxRound=Km(S.pxAlign),S.stroke=vt(S.stroke||null),S.fill=vt(S.fill||null),S._stroke=S._fill=S._paths=S._focus=null;let F=Hv(Yn(1,S.width),1),B=S.points=mn({},{size:F,width:Yn(1,F*.2),stroke:S.stroke,space:F*2,paths:iS,_stroke:null,_fill:null},S.points);B.show=vt(B.show),B.filter=vt(B.filter),B.fill=vt(B.fill),B.stroke=vt(B.stroke),B.paths=vt(B.paths),B.pxAlign=S.pxAlign}if(Q){let F=Pt(S,T);Ye.splice(T,0,F[0]),Be.splice(T,0,F[1]),le.values.push(null)}if(me){te.splice(T,0,null);let F=null;Ce?T==0&&(F=Ko(S,T)):T>0&&(F=Ko(S,T)),ut.splice(T,0,F),Wt.splice(T,0,0),Gn.splice(T,0,0)}An("addSeries",T)}function du(S,T){T=T??v.length,S=s==1?od(S,T,qm,jm):od(S,T,{},Zm),v.splice(T,0,S),Gr(v[T],T)}i.addSeries=du;function vl(S){if(v.splice(S,1),Q){le.values.splice(S,1),Be.splice(S,1);let T=Ye.splice(S,1)[0];xn(null,T.firstChild),T.remove()}me&&(te.splice(S,1),ut.splice(S,1)[0].remove(),Wt.splice(S,1),Gn.splice(S,1)),An("delSeries",S)}i.delSeries=vl;let Xi=[!1,!1,!1,!1];function ds(S,T){if(S._show=S.show,S.show){let F=S.side%2,B=b[S.scale];B==null&&(S.scale=F?v[1].scale:M,B=b[S.scale]);let $=B.time;S.size=vt(S.size),S.space=vt(S.space),S.rotate=vt(S.rotate),Vs(S.incrs)&&S.incrs.forEach(ue=>{!Gs.has(ue)&&Gs.set(ue,ug(ue))}),S.incrs=vt(S.incrs||(B.distr==2?pv:$?p==1?gv:yv:Sr)),S.splits=vt(S.splits||($&&B.distr==1?X:B.distr==3?nd:B.distr==4?Ov:Fv)),S.stroke=vt(S.stroke),S.grid.stroke=vt(S.grid.stroke),S.ticks.stroke=vt(S.ticks.stroke),S.border.stroke=vt(S.border.stroke);let ee=S.values;S.values=Vs(ee)&&!Vs(ee[0])?vt(ee):$?Vs(ee)?Vm(z,zm(ee,O)):Fm(ee)?Mv(z,ee):ee||H:ee||Uv,S.filter=vt(S.filter||(B.distr>=3&&B.log==10?zv:B.distr==3&&B.log==2?Vv:cg)),S.font=ng(S.font),S.labelFont=ng(S.labelFont),S._size=S.size(i,null,T,0),S._space=S._rotate=S._incrs=S._found=S._splits=S._values=null,S._size>0&&(Xi[T]=!0,S._el=Mi(wy,h))}}function fs(S,T,F,B){let[$,ee,ue,_e]=F,Me=T%2,Ue=0;return Me==0&&(_e||ee)&&(Ue=T==0&&!$||T==2&&!ue?vn(Wm.size/3):0),Me==1&&($||ue)&&(Ue=T==1&&!ee||T==3&&!_e?vn(Ym.size/2):0),Ue}let Qo=i.padding=(n.padding||[fs,fs,fs,fs]).map(S=>vt(Et(S,fs))),Ai=i._padding=Qo.map((S,T)=>S(i,T,Xi,0)),en,on=null,an=null,Yi=s==1?v[0].idxs:null,oi=null,Ds=!1;function ea(S,T){if(e=S??[],i.data=i._data=e,s==2){en=0;for(let F=1;F<v.length;F++)en+=e[F][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),oi=e[0],en=oi.length;let F=e;if(U==2){F=e.slice();let B=F[0]=Array(en);for(let $=0;$<en;$++)B[$]=$}i._data=e=F}if(dt(!0),An("setData"),U==2&&(Se=!0),T!==!1){let F=I;F.auto(i,Ds)?ta():Fs(M,F.min,F.max),ie=ie||he.left>=0,xe=!0,Fn()}}i.setData=ea;function ta(){Ds=!0;let S,T;s==1&&(en>0?(on=Yi[0]=0,an=Yi[1]=en-1,S=e[0][on],T=e[0][an],U==2?(S=on,T=an):S==T&&(U==3?[S,T]=Yl(S,S,I.log,!1):U==4?[S,T]=hd(S,S,I.log,!1):I.time?T=S+vn(86400/p):[S,T]=Wl(S,T,ud,!0))):(on=Yi[0]=S=null,an=Yi[1]=T=null)),Fs(M,S,T)}let Hr,Ns,Wr,A,q,ne,J,K,Ae,Le;function Re(S,T,F,B,$,ee){S??=ym,F??=fd,B??="butt",$??=ym,ee??="round",S!=Hr&&(d.strokeStyle=Hr=S),$!=Ns&&(d.fillStyle=Ns=$),T!=Wr&&(d.lineWidth=Wr=T),ee!=q&&(d.lineJoin=q=ee),B!=ne&&(d.lineCap=ne=B),F!=A&&d.setLineDash(A=F)}function De(S,T,F,B){T!=Ns&&(d.fillStyle=Ns=T),S!=J&&(d.font=J=S),F!=K&&(d.textAlign=K=F),B!=Ae&&(d.textBaseline=Ae=B)}function He(S,T,F,B,$=0){if(B.length>0&&S.auto(i,Ds)&&(T==null||T.min==null)){let ee=Et(on,0),ue=Et(an,B.length-1),_e=F.min==null?zy(B,ee,ue,$,S.distr==3):[F.min,F.max];S.min=Ni(S.min,F.min=_e[0]),S.max=Yn(S.max,F.max=_e[1])}}let nt={min:null,max:null};function gt(){for(let B in b){let $=b[B];N[B]==null&&($.min==null||N[M]!=null&&$.auto(i,Ds))&&(N[B]=nt)}for(let B in b){let $=b[B];N[B]==null&&$.from!=null&&N[$.from]!=null&&(N[B]=nt)}N[M]!=null&&dt(!0);let S={};for(let B in N){let $=N[B];if($!=null){let ee=S[B]=fo(b[B],Zy);if($.min!=null)mn(ee,$);else if(B!=M||s==2)if(en==0&&ee.from==null){let ue=ee.range(i,null,null,B);ee.min=ue[0],ee.max=ue[1]}else ee.min=Vt,ee.max=-Vt}}if(en>0){v.forEach((B,$)=>{if(s==1){let ee=B.scale,ue=N[ee];if(ue==null)return;let _e=S[ee];if($==0){let Me=_e.range(i,_e.min,_e.max,ee);_e.min=Me[0],_e.max=Me[1],on=Di(_e.min,e[0]),an=Di(_e.max,e[0]),an-on>1&&(e[0][on]<_e.min&&on++,e[0][an]>_e.max&&an--),B.min=oi[on],B.max=oi[an]}else B.show&&B.auto&&He(_e,ue,B,e[$],B.sorted);B.idxs[0]=on,B.idxs[1]=an}else if($>0&&B.show&&B.auto){let[ee,ue]=B.facets,_e=ee.scale,Me=ue.scale,[Ue,Fe]=e[$],ze=S[_e],ot=S[Me];ze!=null&&He(ze,N[_e],ee,Ue,ee.sorted),ot!=null&&He(ot,N[Me],ue,Fe,ue.sorted),B.min=ue.min,B.max=ue.max}});for(let B in S){let $=S[B],ee=N[B];if($.from==null&&(ee==null||ee.min==null)){let ue=$.range(i,$.min==Vt?null:$.min,$.max==-Vt?null:$.max,B);$.min=ue[0],$.max=ue[1]}}}for(let B in S){let $=S[B];if($.from!=null){let ee=S[$.from];if(ee.min==null)$.min=$.max=null;else{let ue=$.range(i,ee.min,ee.max,B);$.min=ue[0],$.max=ue[1]}}}let T={},F=!1;for(let B in S){let $=S[B],ee=b[B];if(ee.min!=$.min||ee.max!=$.max){ee.min=$.min,ee.max=$.max;let ue=ee.distr;ee._min=ue==3?xs(ee.min):ue==4?Yu(ee.min,ee.asinh):ue==100?ee.fwd(ee.min):ee.min,ee._max=ue==3?xs(ee.max):ue==4?Yu(ee.max,ee.asinh):ue==100?ee.fwd(ee.max):ee.max,T[B]=F=!0}}if(F){v.forEach((B,$)=>{s==2?$>0&&T.y&&(B._paths=null):T[B.scale]&&(B._paths=null)});for(let B in T)Se=!0,An("setScale",B);me&&he.left>=0&&(ie=xe=!0)}for(let B in N)N[B]=null}function Ge(S){let T=td(on-1,0,en-1),F=td(an+1,0,en-1);for(;S[T]==null&&T>0;)T--;for(;S[F]==null&&F<en-1;)F++;return[T,F]}function _t(){if(en>0){let S=v.some(T=>T._focus)&&Le!=Ve.alpha;S&&(d.globalAlpha=Le=Ve.alpha),v.forEach((T,F)=>{if(F>0&&T.show&&(Kt(F,!1),Kt(F,!0),T._paths==null)){let B=Le;Le!=T.alpha&&(d.globalAlpha=Le=T.alpha);let $=s==2?[0,e[F][0].length-1]:Ge(e[F]);T._paths=T.paths(i,F,$[0],$[1]),Le!=B&&(d.globalAlpha=Le=B)}}),v.forEach((T,F)=>{if(F>0&&T.show){let B=Le;Le!=T.alpha&&(d.globalAlpha=Le=T.alpha),T._paths!=null&&Nt(F,!1);{let $=T._paths!=null?T._paths.gaps:null,ee=T.points.show(i,F,on,an,$),ue=T.points.filter(i,F,ee,$);(ee||ue)&&(T.points._paths=T.points.paths(i,F,on,an,ue),Nt(F,!0))}Le!=B&&(d.globalAlpha=Le=B),An("drawSeries",F)}}),S&&(d.globalAlpha=Le=1)}}function Kt(S,T){let F=T?v[S].points:v[S];F._stroke=F.stroke(i,S),F._fill=F.fill(i,S)}function Nt(S,T){let F=T?v[S].points:v[S],{stroke:B,fill:$,clip:ee,flags:ue,_stroke:_e=F._stroke,_fill:Me=F._fill,_width:Ue=F.width}=F._paths;Ue=Gt(Ue*Rt,3);let Fe=null,ze=Ue%2/2;T&&Me==null&&(Me=Ue>0?"#fff":_e);let ot=F.pxAlign==1&&ze>0;if(ot&&d.translate(ze,ze),!T){let Tt=D-Ue/2,wt=w-Ue/2,xt=j+Ue,Qe=pe+Ue;Fe=new Path2D,Fe.rect(Tt,wt,xt,Qe)}T?ke(_e,Ue,F.dash,F.cap,Me,B,$,ue,ee):Ut(S,_e,Ue,F.dash,F.cap,Me,B,$,ue,Fe,ee),ot&&d.translate(-ze,-ze)}function Ut(S,T,F,B,$,ee,ue,_e,Me,Ue,Fe){let ze=!1;Me!=0&&C.forEach((ot,Tt)=>{if(ot.series[0]==S){let wt=v[ot.series[1]],xt=e[ot.series[1]],Qe=(wt._paths||ya).band;Vs(Qe)&&(Qe=ot.dir==1?Qe[0]:Qe[1]);let Xe,Yt=null;wt.show&&Qe&&Gy(xt,on,an)?(Yt=ot.fill(i,Tt)||ee,Xe=wt._paths.clip):Qe=null,ke(T,F,B,$,Yt,ue,_e,Me,Ue,Fe,Xe,Qe),ze=!0}}),ze||ke(T,F,B,$,ee,ue,_e,Me,Ue,Fe)}let yn=po|sd;function ke(S,T,F,B,$,ee,ue,_e,Me,Ue,Fe,ze){Re(S,T,F,B,$),(Me||Ue||ze)&&(d.save(),Me&&d.clip(Me),Ue&&d.clip(Ue)),ze?(_e&yn)==yn?(d.clip(ze),Fe&&d.clip(Fe),yt($,ue),cn(S,ee,T)):_e&sd?(yt($,ue),d.clip(ze),cn(S,ee,T)):_e&po&&(d.save(),d.clip(ze),Fe&&d.clip(Fe),yt($,ue),d.restore(),cn(S,ee,T)):(yt($,ue),cn(S,ee,T)),(Me||Ue||ze)&&d.restore()}function cn(S,T,F){F>0&&(T instanceof Map?T.forEach((B,$)=>{d.strokeStyle=Hr=$,d.stroke(B)}):T!=null&&S&&d.stroke(T))}function yt(S,T){T instanceof Map?T.forEach((F,B)=>{d.fillStyle=Ns=B,d.fill(F)}):T!=null&&S&&d.fill(T)}function ps(S,T,F,B){let $=P[S],ee;if(B<=0)ee=[0,0];else{let ue=$._space=$.space(i,S,T,F,B),_e=$._incrs=$.incrs(i,S,T,F,B,ue);ee=cS(T,F,_e,B,ue)}return $._found=ee}function hn(S,T,F,B,$,ee,ue,_e,Me,Ue){let Fe=ue%2/2;_==1&&d.translate(Fe,Fe),Re(_e,ue,Me,Ue,_e),d.beginPath();let ze,ot,Tt,wt,xt=$+(B==0||B==3?-ee:ee);F==0?(ot=$,wt=xt):(ze=$,Tt=xt);for(let Qe=0;Qe<S.length;Qe++)T[Qe]!=null&&(F==0?ze=Tt=S[Qe]:ot=wt=S[Qe],d.moveTo(ze,ot),d.lineTo(Tt,wt));d.stroke(),_==1&&d.translate(-Fe,-Fe)}function qr(S){let T=!0;return P.forEach((F,B)=>{if(!F.show)return;let $=b[F.scale];if($.min==null){F._show&&(T=!1,F._show=!1,dt(!1));return}else F._show||(T=!1,F._show=!0,dt(!1));let ee=F.side,ue=ee%2,{min:_e,max:Me}=$,[Ue,Fe]=ps(B,_e,Me,ue==0?G:Pe);if(Fe==0)return;let ze=$.distr==2,ot=F._splits=F.splits(i,B,_e,Me,Ue,Fe,ze),Tt=$.distr==2?ot.map(Xe=>oi[Xe]):ot,wt=$.distr==2?oi[ot[1]]-oi[ot[0]]:Ue,xt=F._values=F.values(i,F.filter(i,Tt,B,Fe,wt),B,Fe,wt);F._rotate=ee==2?F.rotate(i,xt,B,Fe):0;let Qe=F._size;F._size=bi(F.size(i,xt,B,S)),Qe!=null&&F._size!=Qe&&(T=!1)}),T}function $i(S){let T=!0;return Qo.forEach((F,B)=>{let $=F(i,B,Xi,S);$!=Ai[B]&&(T=!1),Ai[B]=$}),T}function ms(){for(let S=0;S<P.length;S++){let T=P[S];if(!T.show||!T._show)continue;let F=T.side,B=F%2,$,ee,ue=T.stroke(i,S),_e=F==0||F==3?-1:1,[Me,Ue]=T._found;if(T.label!=null){let qn=T.labelGap*_e,ci=vn((T._lpos+qn)*Rt);De(T.labelFont[0],ue,"center",F==2?"top":xm),d.save(),B==1?($=ee=0,d.translate(ci,vn(w+pe/2)),d.rotate((F==3?-Gl:Gl)/2)):($=vn(D+j/2),ee=ci);let fr=ag(T.label)?T.label(i,S,Me,Ue):T.label;d.fillText(fr,$,ee),d.restore()}if(Ue==0)continue;let Fe=b[T.scale],ze=B==0?j:pe,ot=B==0?D:w,Tt=T._splits,wt=Fe.distr==2?Tt.map(qn=>oi[qn]):Tt,xt=Fe.distr==2?oi[Tt[1]]-oi[Tt[0]]:Me,Qe=T.ticks,Xe=T.border,Yt=Qe.show?Qe.size:0,nn=vn(Yt*Rt),Rn=vn((T.alignTo==2?T._size-Yt-T.gap:T.gap)*Rt),kt=T._rotate*-Gl/180,sn=f(T._pos*Rt),ai=(nn+Rn)*_e,Wn=sn+ai;ee=B==0?Wn:0,$=B==1?Wn:0;let vi=T.font[0],Ri=T.align==1?ao:T.align==2?Wu:kt>0?ao:kt<0?Wu:B==0?"center":F==3?Wu:ao,Ji=kt||B==1?"middle":F==2?"top":xm;De(vi,ue,Ri,Ji);let li=T.font[1]*T.lineGap,Si=Tt.map(qn=>f(a(qn,Fe,ze,ot))),Ci=T._values;for(let qn=0;qn<Ci.length;qn++){let ci=Ci[qn];if(ci!=null){B==0?$=Si[qn]:ee=Si[qn],ci=""+ci;let fr=ci.indexOf(`
`)==-1?[ci]:ci.split(/\n/gm);for(let Xn=0;Xn<fr.length;Xn++){let yp=fr[Xn];kt?(d.save(),d.translate($,ee+Xn*li),d.rotate(kt),d.fillText(yp,0,0),d.restore()):d.fillText(yp,$,ee+Xn*li)}}}Qe.show&&hn(Si,Qe.filter(i,wt,S,Ue,xt),B,F,sn,nn,Gt(Qe.width*Rt,3),Qe.stroke(i,S),Qe.dash,Qe.cap);let Ki=T.grid;Ki.show&&hn(Si,Ki.filter(i,wt,S,Ue,xt),B,B==0?2:1,B==0?w:D,B==0?pe:j,Gt(Ki.width*Rt,3),Ki.stroke(i,S),Ki.dash,Ki.cap),Xe.show&&hn([sn],[1],B==0?1:0,B==0?1:2,B==1?w:D,B==1?pe:j,Gt(Xe.width*Rt,3),Xe.stroke(i,S),Xe.dash,Xe.cap)}An("drawAxes")}function dt(S){v.forEach((T,F)=>{F>0&&(T._paths=null,S&&(s==1?(T.min=null,T.max=null):T.facets.forEach(B=>{B.min=null,B.max=null})))})}let tn=!1,Hn=!1,Ft=[];function un(){Hn=!1;for(let S=0;S<Ft.length;S++)An(...Ft[S]);Ft.length=0}function Fn(){tn||(nv(tp),tn=!0)}function Sl(S,T=!1){tn=!0,Hn=T,S(i),tp(),T&&Ft.length>0&&queueMicrotask(un)}i.batch=Sl;function tp(){if(ce&&(gt(),ce=!1),Se&&(Te(),Se=!1),ve){if($t(m,ao,Je),$t(m,"top",lt),$t(m,ma,G),$t(m,ga,Pe),$t(g,ao,Je),$t(g,"top",lt),$t(g,ma,G),$t(g,ga,Pe),$t(h,ma,Qt),$t(h,ga,ln),u.width=vn(Qt*Rt),u.height=vn(ln*Rt),P.forEach(({_el:S,_show:T,_size:F,_pos:B,side:$})=>{if(S!=null)if(T){let ee=$===3||$===0?F:0,ue=$%2==1;$t(S,ue?"left":"top",B-ee),$t(S,ue?"width":"height",F),$t(S,ue?"top":"left",ue?lt:Je),$t(S,ue?"height":"width",ue?Pe:G),Qu(S,Mr)}else ui(S,Mr)}),Hr=Ns=Wr=q=ne=J=K=Ae=A=null,Le=1,sa(!0),Je!=Ee||lt!=zt||G!=We||Pe!=Ze){dt(!1);let S=G/We,T=Pe/Ze;if(me&&!ie&&he.left>=0){he.left*=S,he.top*=T,Xr&&ts(Xr,vn(he.left),0,G,Pe),Yr&&ts(Yr,0,vn(he.top),G,Pe);for(let F=0;F<ut.length;F++){let B=ut[F];B!=null&&(Wt[F]*=S,Gn[F]*=T,ts(B,bi(Wt[F]),bi(Gn[F]),G,Pe))}}if(Xt.show&&!re&&Xt.left>=0&&Xt.width>0){Xt.left*=S,Xt.width*=S,Xt.top*=T,Xt.height*=T;for(let F in xu)$t(jr,F,Xt[F])}Ee=Je,zt=lt,We=G,Ze=Pe}An("setSize"),ve=!1}Qt>0&&ln>0&&(d.clearRect(0,0,u.width,u.height),An("drawClear"),y.forEach(S=>S()),An("draw")),Xt.show&&re&&(Ml(Xt),re=!1),me&&ie&&(dr(null,!0,!1),ie=!1),le.show&&le.live&&xe&&(gu(),xe=!1),l||(l=!0,i.status=1,An("ready")),Ds=!1,tn=!1}i.redraw=(S,T)=>{Se=T||!1,S!==!1?Fs(M,I.min,I.max):Fn()};function fu(S,T){let F=b[S];if(F.from==null){if(en==0){let B=F.range(i,T.min,T.max,S);T.min=B[0],T.max=B[1]}if(T.min>T.max){let B=T.min;T.min=T.max,T.max=B}if(en>1&&T.min!=null&&T.max!=null&&T.max-T.min<1e-16)return;S==M&&F.distr==2&&en>0&&(T.min=Di(T.min,e[0]),T.max=Di(T.max,e[0]),T.min==T.max&&T.max++),N[S]=T,ce=!0,Fn()}}i.setScale=fu;let pu,mu,Xr,Yr,np,ip,$r,Zr,sp,rp,qt,Jt,Us=!1,Pn=he.drag,En=Pn.x,Tn=Pn.y;me&&(he.x&&(pu=Mi(Ty,g)),he.y&&(mu=Mi(Ay,g)),I.ori==0?(Xr=pu,Yr=mu):(Xr=mu,Yr=pu),qt=he.left,Jt=he.top);let Xt=i.select=mn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),jr=Xt.show?Mi(Ey,Xt.over?g:m):null;function Ml(S,T){if(Xt.show){for(let F in S)Xt[F]=S[F],F in xu&&$t(jr,F,S[F]);T!==!1&&An("setSelect")}}i.setSelect=Ml;function hx(S){if(v[S].show)Q&&Qu(Ye[S],Mr);else if(Q&&ui(Ye[S],Mr),me){let F=Ce?ut[0]:ut[S];F!=null&&ts(F,-10,-10,G,Pe)}}function Fs(S,T,F){fu(S,{min:T,max:F})}function Zi(S,T,F,B){T.focus!=null&&mx(S),T.show!=null&&v.forEach(($,ee)=>{ee>0&&(S==ee||S==null)&&($.show=T.show,hx(ee),s==2?(Fs($.facets[0].scale,null,null),Fs($.facets[1].scale,null,null)):Fs($.scale,null,null),Fn())}),F!==!1&&An("setSeries",S,T),B&&ra("setSeries",i,S,T)}i.setSeries=Zi;function ux(S,T){mn(C[S],T)}function dx(S,T){S.fill=vt(S.fill||null),S.dir=Et(S.dir,-1),T=T??C.length,C.splice(T,0,S)}function fx(S){S==null?C.length=0:C.splice(S,1)}i.addBand=dx,i.setBand=ux,i.delBand=fx;function px(S,T){v[S].alpha=T,me&&ut[S]!=null&&(ut[S].style.opacity=T),Q&&Ye[S]&&(Ye[S].style.opacity=T)}let gs,Os,ur,Jr={focus:!0};function mx(S){if(S!=ur){let T=S==null,F=Ve.alpha!=1;v.forEach((B,$)=>{if(s==1||$>0){let ee=T||$==0||$==S;B._focus=T?null:ee,F&&px($,ee?1:Ve.alpha)}}),ur=S,F&&Fn()}}Q&&tt&&bt(Mm,oe,S=>{he._lock||(et(S),ur!=null&&Zi(null,Jr,!0,dn.setSeries))});function ji(S,T,F){let B=b[T];F&&(S=S/Rt-(B.ori==1?lt:Je));let $=G;B.ori==1&&($=Pe,S=$-S),B.dir==-1&&(S=$-S);let ee=B._min,ue=B._max,_e=S/$,Me=ee+(ue-ee)*_e,Ue=B.distr;return Ue==3?ho(10,Me):Ue==4?Wy(Me,B.asinh):Ue==100?B.bwd(Me):Me}function gx(S,T){let F=ji(S,M,T);return Di(F,e[0],on,an)}i.valToIdx=S=>Di(S,e[0]),i.posToIdx=gx,i.posToVal=ji,i.valToPos=(S,T,F)=>b[T].ori==0?r(S,b[T],F?j:G,F?D:0):o(S,b[T],F?pe:Pe,F?w:0),i.setCursor=(S,T,F)=>{qt=S.left,Jt=S.top,dr(null,T,F)};function op(S,T){$t(jr,ao,Xt.left=S),$t(jr,ma,Xt.width=T)}function ap(S,T){$t(jr,"top",Xt.top=S),$t(jr,ga,Xt.height=T)}let na=I.ori==0?op:ap,ia=I.ori==1?op:ap;function _x(){if(Q&&le.live)for(let S=s==2?1:0;S<v.length;S++){if(S==0&&at)continue;let T=le.values[S],F=0;for(let B in T)Be[S][F++].firstChild.nodeValue=T[B]}}function gu(S,T){if(S!=null&&(S.idxs?S.idxs.forEach((F,B)=>{te[B]=F}):$y(S.idx)||te.fill(S.idx),le.idx=te[0]),Q&&le.live){for(let F=0;F<v.length;F++)(F>0||s==1&&!at)&&xx(F,te[F]);_x()}xe=!1,T!==!1&&An("setLegend")}i.setLegend=gu;function xx(S,T){let F=v[S],B=S==0&&U==2?oi:e[S],$;at?$=F.values(i,S,T)??$e:($=F.value(i,T==null?null:B[T],S,T),$=$==null?$e:{_:$}),le.values[S]=$}function dr(S,T,F){sp=qt,rp=Jt,[qt,Jt]=he.move(i,qt,Jt),he.left=qt,he.top=Jt,me&&(Xr&&ts(Xr,vn(qt),0,G,Pe),Yr&&ts(Yr,0,vn(Jt),G,Pe));let B,$=on>an;gs=Vt,Os=null;let ee=I.ori==0?G:Pe,ue=I.ori==1?G:Pe;if(qt<0||en==0||$){B=he.idx=null;for(let _e=0;_e<v.length;_e++){let Me=ut[_e];Me!=null&&ts(Me,-10,-10,G,Pe)}tt&&Zi(null,Jr,!0,S==null&&dn.setSeries),le.live&&(te.fill(B),xe=!0)}else{let _e,Me,Ue;s==1&&(_e=I.ori==0?qt:Jt,Me=ji(_e,M),B=he.idx=Di(Me,e[0],on,an),Ue=k(e[0][B],I,ee,0));let Fe=-10,ze=-10,ot=0,Tt=0,wt=!0,xt="",Qe="";for(let Xe=s==2?1:0;Xe<v.length;Xe++){let Yt=v[Xe],nn=te[Xe],Rn=nn==null?null:s==1?e[Xe][nn]:e[Xe][1][nn],kt=he.dataIdx(i,Xe,B,Me),sn=kt==null?null:s==1?e[Xe][kt]:e[Xe][1][kt];if(xe=xe||sn!=Rn||kt!=nn,te[Xe]=kt,Xe>0&&Yt.show){let ai=kt==null?-10:kt==B?Ue:k(s==1?e[0][kt]:e[Xe][0][kt],I,ee,0),Wn=sn==null?-10:E(sn,s==1?b[Yt.scale]:b[Yt.facets[1].scale],ue,0);if(tt&&sn!=null){let vi=I.ori==1?qt:Jt,Ri=Sn(Ve.dist(i,Xe,kt,Wn,vi));if(Ri<gs){let Ji=Ve.bias;if(Ji!=0){let li=ji(vi,Yt.scale),Si=sn>=0?1:-1,Ci=li>=0?1:-1;Ci==Si&&(Ci==1?Ji==1?sn>=li:sn<=li:Ji==1?sn<=li:sn>=li)&&(gs=Ri,Os=Xe)}else gs=Ri,Os=Xe}}if(xe||Ce){let vi,Ri;I.ori==0?(vi=ai,Ri=Wn):(vi=Wn,Ri=ai);let Ji,li,Si,Ci,Ki,qn,ci=!0,fr=fe.bbox;if(fr!=null){ci=!1;let Xn=fr(i,Xe);Si=Xn.left,Ci=Xn.top,Ji=Xn.width,li=Xn.height}else Si=vi,Ci=Ri,Ji=li=fe.size(i,Xe);if(qn=fe.fill(i,Xe),Ki=fe.stroke(i,Xe),Ce)Xe==Os&&gs<=Ve.prox&&(Fe=Si,ze=Ci,ot=Ji,Tt=li,wt=ci,xt=qn,Qe=Ki);else{let Xn=ut[Xe];Xn!=null&&(Wt[Xe]=Si,Gn[Xe]=Ci,Cm(Xn,Ji,li,ci),Am(Xn,qn,Ki),ts(Xn,bi(Si),bi(Ci),G,Pe))}}}}if(Ce){let Xe=Ve.prox,Yt=ur==null?gs<=Xe:gs>Xe||Os!=ur;if(xe||Yt){let nn=ut[0];nn!=null&&(Wt[0]=Fe,Gn[0]=ze,Cm(nn,ot,Tt,wt),Am(nn,xt,Qe),ts(nn,bi(Fe),bi(ze),G,Pe))}}}if(Xt.show&&Us)if(S!=null){let[_e,Me]=dn.scales,[Ue,Fe]=dn.match,[ze,ot]=S.cursor.sync.scales,Tt=S.cursor.drag;if(En=Tt._x,Tn=Tt._y,En||Tn){let{left:wt,top:xt,width:Qe,height:Xe}=S.select,Yt=S.scales[ze].ori,nn=S.posToVal,Rn,kt,sn,ai,Wn,vi=_e!=null&&Ue(_e,ze),Ri=Me!=null&&Fe(Me,ot);vi&&En?(Yt==0?(Rn=wt,kt=Qe):(Rn=xt,kt=Xe),sn=b[_e],ai=k(nn(Rn,ze),sn,ee,0),Wn=k(nn(Rn+kt,ze),sn,ee,0),na(Ni(ai,Wn),Sn(Wn-ai))):na(0,ee),Ri&&Tn?(Yt==1?(Rn=wt,kt=Qe):(Rn=xt,kt=Xe),sn=b[Me],ai=E(nn(Rn,ot),sn,ue,0),Wn=E(nn(Rn+kt,ot),sn,ue,0),ia(Ni(ai,Wn),Sn(Wn-ai))):ia(0,ue)}else yu()}else{let _e=Sn(sp-np),Me=Sn(rp-ip);if(I.ori==1){let ot=_e;_e=Me,Me=ot}En=Pn.x&&_e>=Pn.dist,Tn=Pn.y&&Me>=Pn.dist;let Ue=Pn.uni;Ue!=null?En&&Tn&&(En=_e>=Ue,Tn=Me>=Ue,!En&&!Tn&&(Me>_e?Tn=!0:En=!0)):Pn.x&&Pn.y&&(En||Tn)&&(En=Tn=!0);let Fe,ze;En&&(I.ori==0?(Fe=$r,ze=qt):(Fe=Zr,ze=Jt),na(Ni(Fe,ze),Sn(ze-Fe)),Tn||ia(0,ue)),Tn&&(I.ori==1?(Fe=$r,ze=qt):(Fe=Zr,ze=Jt),ia(Ni(Fe,ze),Sn(ze-Fe)),En||na(0,ee)),!En&&!Tn&&(na(0,0),ia(0,0))}if(Pn._x=En,Pn._y=Tn,S==null){if(F){if(xp!=null){let[_e,Me]=dn.scales;dn.values[0]=_e!=null?ji(I.ori==0?qt:Jt,_e):null,dn.values[1]=Me!=null?ji(I.ori==1?qt:Jt,Me):null}ra(qu,i,qt,Jt,G,Pe,B)}if(tt){let _e=F&&dn.setSeries,Me=Ve.prox;ur==null?gs<=Me&&Zi(Os,Jr,!0,_e):gs>Me?Zi(null,Jr,!0,_e):Os!=ur&&Zi(Os,Jr,!0,_e)}}xe&&(le.idx=B,gu()),T!==!1&&An("setCursor")}let Bs=null;Object.defineProperty(i,"rect",{get(){return Bs==null&&sa(!1),Bs}});function sa(S=!1){S?Bs=null:(Bs=g.getBoundingClientRect(),An("syncRect",Bs))}function lp(S,T,F,B,$,ee,ue){he._lock||Us&&S!=null&&S.movementX==0&&S.movementY==0||(_u(S,T,F,B,$,ee,ue,!1,S!=null),S!=null?dr(null,!0,!0):dr(T,!0,!1))}function _u(S,T,F,B,$,ee,ue,_e,Me){if(Bs==null&&sa(!1),et(S),S!=null)F=S.clientX-Bs.left,B=S.clientY-Bs.top;else{if(F<0||B<0){qt=-10,Jt=-10;return}let[Ue,Fe]=dn.scales,ze=T.cursor.sync,[ot,Tt]=ze.values,[wt,xt]=ze.scales,[Qe,Xe]=dn.match,Yt=T.axes[0].side%2==1,nn=I.ori==0?G:Pe,Rn=I.ori==1?G:Pe,kt=Yt?ee:$,sn=Yt?$:ee,ai=Yt?B:F,Wn=Yt?F:B;if(wt!=null?F=Qe(Ue,wt)?a(ot,b[Ue],nn,0):-10:F=nn*(ai/kt),xt!=null?B=Xe(Fe,xt)?a(Tt,b[Fe],Rn,0):-10:B=Rn*(Wn/sn),I.ori==1){let vi=F;F=B,B=vi}}Me&&(T==null||T.cursor.event.type==qu)&&((F<=1||F>=G-1)&&(F=vr(F,G)),(B<=1||B>=Pe-1)&&(B=vr(B,Pe))),_e?(np=F,ip=B,[$r,Zr]=he.move(i,F,B)):(qt=F,Jt=B)}let xu={width:0,height:0,left:0,top:0};function yu(){Ml(xu,!1)}let cp,hp,up,dp;function fp(S,T,F,B,$,ee,ue){Us=!0,En=Tn=Pn._x=Pn._y=!1,_u(S,T,F,B,$,ee,ue,!0,!1),S!=null&&(bt(Xu,Ju,pp,!1),ra(vm,i,$r,Zr,G,Pe,null));let{left:_e,top:Me,width:Ue,height:Fe}=Xt;cp=_e,hp=Me,up=Ue,dp=Fe}function pp(S,T,F,B,$,ee,ue){Us=Pn._x=Pn._y=!1,_u(S,T,F,B,$,ee,ue,!1,!0);let{left:_e,top:Me,width:Ue,height:Fe}=Xt,ze=Ue>0||Fe>0,ot=cp!=_e||hp!=Me||up!=Ue||dp!=Fe;if(ze&&ot&&Ml(Xt),Pn.setScale&&ze&&ot){let Tt=_e,wt=Ue,xt=Me,Qe=Fe;if(I.ori==1&&(Tt=Me,wt=Fe,xt=_e,Qe=Ue),En&&Fs(M,ji(Tt,M),ji(Tt+wt,M)),Tn)for(let Xe in b){let Yt=b[Xe];Xe!=M&&Yt.from==null&&Yt.min!=Vt&&Fs(Xe,ji(xt+Qe,Xe),ji(xt,Xe))}yu()}else he.lock&&(he._lock=!he._lock,dr(T,!0,S!=null));S!=null&&(xn(Xu,Ju),ra(Xu,i,qt,Jt,G,Pe,null))}function yx(S,T,F,B,$,ee,ue){if(he._lock)return;et(S);let _e=Us;if(Us){let Me=!0,Ue=!0,Fe=10,ze,ot;I.ori==0?(ze=En,ot=Tn):(ze=Tn,ot=En),ze&&ot&&(Me=qt<=Fe||qt>=G-Fe,Ue=Jt<=Fe||Jt>=Pe-Fe),ze&&Me&&(qt=qt<$r?0:G),ot&&Ue&&(Jt=Jt<Zr?0:Pe),dr(null,!0,!0),Us=!1}qt=-10,Jt=-10,te.fill(null),dr(null,!0,!0),_e&&(Us=_e)}function mp(S,T,F,B,$,ee,ue){he._lock||(et(S),ta(),yu(),S!=null&&ra(bm,i,qt,Jt,G,Pe,null))}function gp(){P.forEach(hS),V(i.width,i.height,!0)}br(Hl,co,gp);let Kr={};Kr.mousedown=fp,Kr.mousemove=lp,Kr.mouseup=pp,Kr.dblclick=mp,Kr.setSeries=(S,T,F,B)=>{let $=dn.match[2];F=$(i,T,F),F!=-1&&Zi(F,B,!0,!1)},me&&(bt(vm,g,fp),bt(qu,g,lp),bt(Sm,g,S=>{et(S),sa(!1)}),bt(Mm,g,yx),bt(bm,g,mp),rd.add(i),i.syncRect=sa);let bl=i.hooks=n.hooks||{};function An(S,T,F){Hn?Ft.push([S,T,F]):S in bl&&bl[S].forEach(B=>{B.call(null,i,T,F)})}(n.plugins||[]).forEach(S=>{for(let T in S.hooks)bl[T]=(bl[T]||[]).concat(S.hooks[T])});let _p=(S,T,F)=>F,dn=mn({key:null,setSeries:!1,filters:{pub:Nm,sub:Nm},scales:[M,v[1]?v[1].scale:null],match:[Um,Um,_p],values:[null,null]},he.sync);dn.match.length==2&&dn.match.push(_p),he.sync=dn;let xp=dn.key,vu=Ig(xp);function ra(S,T,F,B,$,ee,ue){dn.filters.pub(S,T,F,B,$,ee,ue)&&vu.pub(S,T,F,B,$,ee,ue)}vu.sub(i);function vx(S,T,F,B,$,ee,ue){dn.filters.sub(S,T,F,B,$,ee,ue)&&Kr[S](null,T,F,B,$,ee,ue)}i.pub=vx;function Sx(){vu.unsub(i),rd.delete(i),rn.clear(),ed(Hl,co,gp),c.remove(),oe?.remove(),An("destroy")}i.destroy=Sx;function Su(){An("init",n,e),ea(e||n.data,!1),N[M]?fu(M,N[M]):ta(),re=Xt.show&&(Xt.width>0||Xt.height>0),ie=xe=!0,V(n.width,n.height)}return v.forEach(Gr),P.forEach(ds),t?t instanceof HTMLElement?(t.appendChild(c),Su()):t(i,Su):Su(),i}In.assign=mn;In.fmtNum=dd;In.rangeNum=Wl;In.rangeLog=Yl;In.rangeAsinh=hd;In.orient=Er;In.pxRatio=Rt;In.join=tv;In.fmtDate=pd,In.tzDate=dv;In.sync=Ig;{In.addGap=$v,In.clipGaps=jl;let n=In.paths={points:Og};n.linear=kg,n.stepped=Jv,n.bars=Kv,n.spline=eS}var uS="robot-dynamics",Tr=n=>getComputedStyle(document.documentElement).getPropertyValue(n).trim();function dS(n){let{joints:e,ofBase:t,units:i,trajectory:s}=n,{name:r}=n.tip(),o=(d,h,m)=>({values:s[d].map(g=>g[h]*m),now:g=>g[d][h]*m}),a=(d,h,m,g)=>({key:d,title:h,curves:e.map((_,f)=>({joint:f,name:_.name,unit:m(_.type),color:`--joint-${f%8}`,isDashed:f>=8,...o(d,d==="q"?f:t+f,g?i.factor(_.type):1)}))}),l=(d,h,m,g,_,f)=>({joint:null,name:d,sign:h,values:m,unit:g,color:_,now:f}),c=d=>s.tip.map(h=>h[d]),u=[a("q",["q","positions"],i.position,!0),a("qd",["q\u0307","velocities"],i.velocity,!0),a("qdd",["q\u0308","accelerations"],i.acceleration,!0),a("tau",["\u03C4","torques and forces"],i.force,!1),{key:"energy",title:["E","energies"],curves:[l("kinetic","T",s.kinetic,"J","--joint-0",({kinetic:d})=>d),l("potential","U",s.potential,"J","--joint-1",({potential:d})=>d),l("total","T+U",s.total,"J","--ink",({kinetic:d,potential:h})=>d+h)]},{key:"tip",title:["p",r],curves:[0,1,2].map(d=>l("xyz"[d],"xyz"[d],c(d),"m",`--axis-${"xyz"[d]}`,({tip:h})=>h[d][3]))}];return t>0?[...u.filter(({curves:d})=>d.length>0),...fS(n,o,l)]:u}function fS({freedoms:n,ofBase:e,units:t,trajectory:i},s,r){let o=(u,d,h,m,g)=>({key:`base-${u}`,title:d,curves:n.slice(0,e).map((_,f)=>({joint:null,name:_.name,sign:h(_),unit:m(_.type),color:`--axis-${_.axis}`,isDashed:f>=3,...s(u,f,g?t.factor(_.type):1)}))}),a=[0,1,2].map(u=>{let d=({base:h})=>_s(h)[u];return r("xyz"[u],"xyz"[u],i.base.map(h=>d({base:h})),"m",`--axis-${"xyz"[u]}`,d)}),l=({velocity:u,axis:d})=>`${u}${d}`,c=({force:u,axis:d})=>`${u}${d}`;return[{key:"base",title:["p","base"],curves:a},o("qd",["v, \u03C9","of the base"],l,t.velocity,!0),o("tau",["f, n","acting on the base"],c,t.force,!1)]}function pS(n,e){if(n===null||!Number.isFinite(n+e))return[-1,1];let t=e-n,i=Math.max(Math.abs(n),Math.abs(e));return t<=1e-9*i||t<1e-12?i<1e-12?[-1,1]:[n-.5*i,e+.5*i]:[n-.06*t,e+.06*t]}function mS(n,e,t,i){let[s,r,o]=["--ink","--line","--muted"].map(Tr),a=[...new Set(n.curves.map(({unit:u})=>u))],l="11px system-ui, sans-serif",c=(u,d,h)=>({scale:u,side:d,stroke:o,font:l,size:46,gap:3,grid:{show:h,stroke:r,width:1},ticks:{show:!1},values:(m,g)=>g.map(_=>String(Number(_.toPrecision(6))))});return{width:e,height:t,padding:[8,a.length>1?0:12,0,0],legend:{show:!1},cursor:{sync:{key:uS},drag:{x:!1,y:!1},points:{size:6},y:!1},focus:{alpha:.3},scales:{x:{time:!1,range:()=>[i[0],i[i.length-1]||1]},...Object.fromEntries(a.map(u=>[u,{range:(d,h,m)=>pS(h,m)}]))},axes:[{stroke:o,font:l,size:26,gap:3,grid:{stroke:r,width:1},ticks:{show:!1},values:(u,d)=>d.map(h=>`${Number(h.toPrecision(6))}`)},...a.map((u,d)=>c(u,d===0?3:1,d===0))],series:[{},...n.curves.map(({name:u,unit:d,color:h,isDashed:m})=>({label:u,scale:d,stroke:Tr(h)||s,width:1.8,dash:m?[5,4]:void 0,points:{show:!1}}))]}}function Hg(n){let{joints:e}=n,t=new Set,i=W("div",{class:"plots"}),s=W("p",{class:"status",role:"status","data-key":"status"}),r=[],o=W("div",{class:"legend",role:"group","aria-label":"Joints in the plots"},e.map((_,f)=>{let p=W("button",{type:"button",class:"chip","aria-pressed":!0});return p.style.setProperty("--color",`var(--joint-${f%8})`),p.append(W("span",{class:"dot"}),_.name),p.addEventListener("click",()=>{t.delete(f)||t.add(f),p.setAttribute("aria-pressed",!t.has(f)),r.forEach(({plot:v,chart:P,readings:b})=>v.curves.forEach(({joint:C},M)=>{C===f&&(P.setSeries(M+1,{show:!t.has(f)}),b[M].hidden=t.has(f))}))}),p})),a=W("button",{type:"button",class:"quiet","data-key":"csv"},"Save as CSV");a.addEventListener("click",()=>{let _=n.freedoms.map(v=>v.name),f=sm(n.trajectory,_),p=W("a",{href:URL.createObjectURL(new Blob([f],{type:"text/csv"}))});p.download=`${n.table.name}.csv`,p.click(),setTimeout(()=>URL.revokeObjectURL(p.href),1e3)});function l(){let{trajectory:_}=n;if(r.forEach(({chart:p})=>p.destroy()),r=[],i.replaceChildren(),g.hidden=_===null,!_)return;d();let f=_.t.length>1;if(a.disabled=!f,!!f){for(let p of dS(n)){let[v,P]=p.title,b=[...new Set(p.curves.map(({unit:U})=>U))],C=p.curves.map(({color:U,sign:k,joint:E})=>{let N=W("span",{class:"reading"});return N.style.setProperty("--color",`var(${U})`),N.append(...k?[W("i",{},k)]:fn(v,E+1)," ",W("data")),N}),M=W("div",{class:"chart",role:"img","aria-label":`${P} over time, ${b.join(" and ")}`}),x=W("figure",{"data-plot":p.key},W("figcaption",{},W("b",{},W("i",{},v)),` ${P}, ${b.join(" and ")}`),W("div",{class:"readings"},C),M);i.append(x);let y=168,L=[_.t,...p.curves.map(({values:U})=>U)],R=new In(mS(p,Math.max(M.clientWidth,120),y,_.t),L,M),I=W("div",{class:"playhead"});R.over.append(I),c(R),p.curves.forEach(({joint:U},k)=>{U===null||!t.has(U)||(R.setSeries(k+1,{show:!1}),C[k].hidden=!0)}),r.push({plot:p,chart:R,head:I,readings:C,canvas:M})}m(),u()}}function c(_){let f=p=>{let{left:v}=_.over.getBoundingClientRect();n.play(!1),n.setTime(_.posToVal(p.clientX-v,"x"))};_.over.addEventListener("pointerdown",p=>{_.over.setPointerCapture(p.pointerId),f(p)}),_.over.addEventListener("pointermove",p=>{_.over.hasPointerCapture(p.pointerId)&&f(p)})}function u(){let{trajectory:_,state:f}=n;if(!_||r.length===0)return;let p=n.evaluated();for(let{plot:v,chart:P,head:b,readings:C}of r)b.style.transform=`translateX(${P.valToPos(f.t,"x")}px)`,v.curves.forEach(({now:M},x)=>{let y=C[x].lastChild;y.value=String(M(p)),y.textContent=pr(M(p))})}function d(){let{trajectory:_,state:f,table:p}=n,v=[],P=_.t.length>1;if(_.ended){let{t:b,reason:C}=_.ended;v.push(P?`Ends at ${pr(b)} s: ${C}.`:`The motion cannot begin: ${C}.`)}if(f.mode==="free"&&P){let b=_.energyScale>0?_.drift/_.energyScale:0;v.push(`Integrated by DOP853. Energy and work balance to ${_.drift.toExponential(1)} J, ${b.toExponential(1)} of what is exchanged.`);let C=e.filter((M,x)=>{let{limits:y}=p.rows.find(L=>L.joint===x);return y&&_.q.some(L=>L[x]<y[0]-1e-9||L[x]>y[1]+1e-9)});C.length>0&&v.push(`Limits are no stops here: ${C.map(M=>M.name).join(", ")} passed them.`)}s.textContent=v.join(" "),s.classList.toggle("warning",!!_.ended)}let h=new ResizeObserver(()=>{for(let{chart:_,canvas:f}of r){let p=f.clientWidth;p>0&&p!==_.width&&_.setSize({width:p,height:_.height})}u()}),m=()=>r.forEach(({canvas:_})=>h.observe(_)),g=W("section",{class:"panel","aria-label":"Plots"},W("div",{class:"bar"},o,a),s,i);return n.on("trajectory units theme",()=>g.isConnected&&l()),n.on("time",u),{section:g,build:l}}var tr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},nr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},S0=0,jd=1,M0=2;var sl=1,b0=2,Wo=3,ir=0,ti=1,rs=2,Dr=0,qo=1,Jd=2,Kd=3,Qd=4,w0=5;var Nr=100,E0=101,T0=102,A0=103,R0=104,C0=200,P0=201,I0=202,L0=203,ef=204,tf=205,D0=206,N0=207,U0=208,F0=209,O0=210,B0=211,k0=212,z0=213,V0=214,Ec=0,Tc=1,Ac=2,No=3,Rc=4,Cc=5,Pc=6,Ic=7,nf=0,G0=1,H0=2,os=0,sf=1,rf=2,of=3,af=4,lf=5,cf=6,hf=7;var uf=300,Ur=301,Xo=302,lh=303,ch=304,Lc=1e3,is=1001,Dc=1002,_n=1003,W0=1004;var rl=1005;var Kn=1006,hh=1007;var Cs=1008;var si=1009,df=1010,ff=1011,Yo=1012,uh=1013,Gi=1014,Hi=1015,Wi=1016,dh=1017,fh=1018,Fr=1020,pf=35902,mf=35899,gf=1021,_f=1022,qi=1023,Ts=1026,Ps=1027,xf=1028,ph=1029,sr=1030,mh=1031;var gh=1033,ol=33776,al=33777,ll=33778,cl=33779,_h=35840,xh=35841,yh=35842,vh=35843,Sh=36196,Mh=37492,bh=37496,wh=37488,Eh=37489,hl=37490,Th=37491,Ah=37808,Rh=37809,Ch=37810,Ph=37811,Ih=37812,Lh=37813,Dh=37814,Nh=37815,Uh=37816,Fh=37817,Oh=37818,Bh=37819,kh=37820,zh=37821,Vh=36492,Gh=36494,Hh=36495,Wh=36283,qh=36284,ul=36285,Xh=36286;var Ca=2300,Nc=2301,bc=2302,Hd=2303,Wd=2400,qd=2401,Xd=2402;var q0=3200;var Yh=0,X0=1,Is="",Zn="srgb",Pa="srgb-linear",Ia="linear",Lt="srgb";var wc=7680;var Y0=519,$0=512,Z0=513,j0=514,yf=515,J0=516,K0=517,vf=518,Sf=519,Mf=35044;var bf="300 es",Ei=2e3,Uo=2001;function gS(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function _S(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function La(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Q0(){let n=La("canvas");return n.style.display="block",n}var Wg={},Fo=null;function Da(...n){let e="THREE."+n.shift();Fo?Fo("log",e,...n):console.log(e,...n)}function e_(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function je(...n){n=e_(n);let e="THREE."+n.shift();if(Fo)Fo("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function it(...n){n=e_(n);let e="THREE."+n.shift();if(Fo)Fo("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function Ta(...n){let e=n.join(" ");e in Wg||(Wg[e]=!0,je(...n))}function t_(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var n_={[Ec]:Ec,[Ac]:Pc,[Rc]:Rc,[No]:Cc,[Tc]:Tc,[Pc]:Ac,[Ic]:Ic,[Cc]:No},ki=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Bn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],qg=1234567,Aa=Math.PI/180,Oo=180/Math.PI;function rr(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Bn[n&255]+Bn[n>>8&255]+Bn[n>>16&255]+Bn[n>>24&255]+"-"+Bn[e&255]+Bn[e>>8&255]+"-"+Bn[e>>16&15|64]+Bn[e>>24&255]+"-"+Bn[t&63|128]+Bn[t>>8&255]+"-"+Bn[t>>16&255]+Bn[t>>24&255]+Bn[i&255]+Bn[i>>8&255]+Bn[i>>16&255]+Bn[i>>24&255]).toLowerCase()}function ct(n,e,t){return Math.max(e,Math.min(t,n))}function wf(n,e){return(n%e+e)%e}function xS(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function yS(n,e,t){return n!==e?(t-n)/(e-n):0}function Ra(n,e,t){return(1-t)*n+t*e}function vS(n,e,t,i){return Ra(n,e,1-Math.exp(-t*i))}function SS(n,e=1){return e-Math.abs(wf(n,e*2)-e)}function MS(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function bS(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function wS(n,e){return n+Math.floor(Math.random()*(e-n+1))}function ES(n,e){return n+Math.random()*(e-n)}function TS(n){return n*(.5-Math.random())}function AS(n){n!==void 0&&(qg=n);let e=qg+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function RS(n){return n*Aa}function CS(n){return n*Oo}function PS(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function IS(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Ef(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function LS(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),u=o((e+i)/2),d=r((e-i)/2),h=o((e-i)/2),m=r((i-e)/2),g=o((i-e)/2);switch(s){case"XYX":n.set(a*u,l*d,l*h,a*c);break;case"YZY":n.set(l*h,a*u,l*d,a*c);break;case"ZXZ":n.set(l*d,l*h,a*u,a*c);break;case"XZX":n.set(a*u,l*g,l*m,a*c);break;case"YXY":n.set(l*m,a*u,l*g,a*c);break;case"ZYZ":n.set(l*g,l*m,a*u,a*c);break;default:je("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function $h(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Tf(n,e){if(e.constructor===Float32Array)return n;let t=$h(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function Af(n,e){if(e.constructor===Float32Array)return n;let t=$h(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var dl={DEG2RAD:Aa,RAD2DEG:Oo,generateUUID:rr,clamp:ct,euclideanModulo:wf,mapLinear:xS,inverseLerp:yS,lerp:Ra,damp:vS,pingpong:SS,smoothstep:MS,smootherstep:bS,randInt:wS,randFloat:ES,randFloatSpread:TS,seededRandom:AS,degToRad:RS,radToDeg:CS,isPowerOfTwo:PS,ceilPowerOfTwo:IS,floorPowerOfTwo:Ef,setQuaternionFromProperEuler:LS,normalize:Af,denormalize:Tf},Lf=class Lf{constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ct(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}};Lf.prototype.isVector2=!0;var Ke=Lf,Qn=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],d=i[s+3],h=r[o+0],m=r[o+1],g=r[o+2],_=r[o+3];if(d!==_||l!==h||c!==m||u!==g){let f=l*h+c*m+u*g+d*_;f<0&&(h=-h,m=-m,g=-g,_=-_,f=-f);let p=1-a;if(f<.9995){let v=Math.acos(f),P=Math.sin(v);p=Math.sin(p*v)/P,a=Math.sin(a*v)/P,l=l*p+h*a,c=c*p+m*a,u=u*p+g*a,d=d*p+_*a}else{l=l*p+h*a,c=c*p+m*a,u=u*p+g*a,d=d*p+_*a;let v=1/Math.sqrt(l*l+c*c+u*u+d*d);l*=v,c*=v,u*=v,d*=v}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=d}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],d=r[o],h=r[o+1],m=r[o+2],g=r[o+3];return e[t]=a*g+u*d+l*m-c*h,e[t+1]=l*g+u*h+c*d-a*m,e[t+2]=c*g+u*m+a*h-l*d,e[t+3]=u*g-a*d-l*h-c*m,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),d=a(r/2),h=l(i/2),m=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=h*u*d+c*m*g,this._y=c*m*d-h*u*g,this._z=c*u*g+h*m*d,this._w=c*u*d-h*m*g;break;case"YXZ":this._x=h*u*d+c*m*g,this._y=c*m*d-h*u*g,this._z=c*u*g-h*m*d,this._w=c*u*d+h*m*g;break;case"ZXY":this._x=h*u*d-c*m*g,this._y=c*m*d+h*u*g,this._z=c*u*g+h*m*d,this._w=c*u*d-h*m*g;break;case"ZYX":this._x=h*u*d-c*m*g,this._y=c*m*d+h*u*g,this._z=c*u*g-h*m*d,this._w=c*u*d+h*m*g;break;case"YZX":this._x=h*u*d+c*m*g,this._y=c*m*d+h*u*g,this._z=c*u*g-h*m*d,this._w=c*u*d-h*m*g;break;case"XZY":this._x=h*u*d-c*m*g,this._y=c*m*d-h*u*g,this._z=c*u*g+h*m*d,this._w=c*u*d+h*m*g;break;default:je("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],d=t[10],h=i+a+d;if(h>0){let m=.5/Math.sqrt(h+1);this._w=.25/m,this._x=(u-l)*m,this._y=(r-c)*m,this._z=(o-s)*m}else if(i>a&&i>d){let m=2*Math.sqrt(1+i-a-d);this._w=(u-l)/m,this._x=.25*m,this._y=(s+o)/m,this._z=(r+c)/m}else if(a>d){let m=2*Math.sqrt(1+a-i-d);this._w=(r-c)/m,this._x=(s+o)/m,this._y=.25*m,this._z=(l+u)/m}else{let m=2*Math.sqrt(1+d-i-a);this._w=(o-s)/m,this._x=(r+c)/m,this._y=(l+u)/m,this._z=.25*m}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ct(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},Df=class Df{constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Xg.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Xg.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),d=2*(r*i-o*t);return this.x=t+l*c+o*d-a*u,this.y=i+l*u+a*c-r*d,this.z=s+l*d+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this.z=ct(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this.z=ct(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Sd.copy(this).projectOnVector(e),this.sub(Sd)}reflect(e){return this.sub(Sd.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ct(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}};Df.prototype.isVector3=!0;var Y=Df,Sd=new Y,Xg=new Qn,Nf=class Nf{constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],d=i[7],h=i[2],m=i[5],g=i[8],_=s[0],f=s[3],p=s[6],v=s[1],P=s[4],b=s[7],C=s[2],M=s[5],x=s[8];return r[0]=o*_+a*v+l*C,r[3]=o*f+a*P+l*M,r[6]=o*p+a*b+l*x,r[1]=c*_+u*v+d*C,r[4]=c*f+u*P+d*M,r[7]=c*p+u*b+d*x,r[2]=h*_+m*v+g*C,r[5]=h*f+m*P+g*M,r[8]=h*p+m*b+g*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],d=u*o-a*c,h=a*l-u*r,m=c*r-o*l,g=t*d+i*h+s*m;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/g;return e[0]=d*_,e[1]=(s*c-u*i)*_,e[2]=(a*i-s*o)*_,e[3]=h*_,e[4]=(u*t-s*l)*_,e[5]=(s*r-a*t)*_,e[6]=m*_,e[7]=(i*l-c*t)*_,e[8]=(o*t-i*r)*_,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Ta("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Md.makeScale(e,t)),this}rotate(e){return Ta("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Md.makeRotation(-e)),this}translate(e,t){return Ta("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Md.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}};Nf.prototype.isMatrix3=!0;var rt=Nf,Md=new rt,Yg=new rt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),$g=new rt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function DS(){let n={enabled:!0,workingColorSpace:Pa,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Lt&&(s.r=Es(s.r),s.g=Es(s.g),s.b=Es(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Lt&&(s.r=Do(s.r),s.g=Do(s.g),s.b=Do(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Is?Ia:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Pa]:{primaries:e,whitePoint:i,transfer:Ia,toXYZ:Yg,fromXYZ:$g,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Zn},outputColorSpaceConfig:{drawingBufferColorSpace:Zn}},[Zn]:{primaries:e,whitePoint:i,transfer:Lt,toXYZ:Yg,fromXYZ:$g,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Zn}}}),n}var St=DS();function Es(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Do(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var xo,Uc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{xo===void 0&&(xo=La("canvas")),xo.width=e.width,xo.height=e.height;let s=xo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=xo}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=La("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Es(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Es(t[i]/255)*255):t[i]=Es(t[i]);return{data:t,width:e.width,height:e.height}}else return je("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},NS=0,Bo=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:NS++}),this.uuid=rr(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(bd(s[o].image)):r.push(bd(s[o]))}else r=bd(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function bd(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Uc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(je("Texture: Unable to serialize Texture."),{})}var US=0,wd=new Y,ei=class n extends ki{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=is,s=is,r=Kn,o=Cs,a=qi,l=si,c=n.DEFAULT_ANISOTROPY,u=Is){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:US++}),this.uuid=rr(),this.name="",this.source=new Bo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Ke(0,0),this.repeat=new Ke(1,1),this.center=new Ke(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new rt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(wd).x}get height(){return this.source.getSize(wd).y}get depth(){return this.source.getSize(wd).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){je(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){je(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==uf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Lc:e.x=e.x-Math.floor(e.x);break;case is:e.x=e.x<0?0:1;break;case Dc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Lc:e.y=e.y-Math.floor(e.y);break;case is:e.y=e.y<0?0:1;break;case Dc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ei.DEFAULT_IMAGE=null;ei.DEFAULT_MAPPING=uf;ei.DEFAULT_ANISOTROPY=1;var Uf=class Uf{constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],d=l[8],h=l[1],m=l[5],g=l[9],_=l[2],f=l[6],p=l[10];if(Math.abs(u-h)<.01&&Math.abs(d-_)<.01&&Math.abs(g-f)<.01){if(Math.abs(u+h)<.1&&Math.abs(d+_)<.1&&Math.abs(g+f)<.1&&Math.abs(c+m+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let P=(c+1)/2,b=(m+1)/2,C=(p+1)/2,M=(u+h)/4,x=(d+_)/4,y=(g+f)/4;return P>b&&P>C?P<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(P),s=M/i,r=x/i):b>C?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=M/s,r=y/s):C<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),i=x/r,s=y/r),this.set(i,s,r,t),this}let v=Math.sqrt((f-g)*(f-g)+(d-_)*(d-_)+(h-u)*(h-u));return Math.abs(v)<.001&&(v=1),this.x=(f-g)/v,this.y=(d-_)/v,this.z=(h-u)/v,this.w=Math.acos((c+m+p-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this.z=ct(this.z,e.z,t.z),this.w=ct(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this.z=ct(this.z,e,t),this.w=ct(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}};Uf.prototype.isVector4=!0;var Dt=Uf,Fc=class extends ki{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Kn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Dt(0,0,e,t),this.scissorTest=!1,this.viewport=new Dt(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new ei({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Kn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Bo(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},_i=class extends Fc{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},Na=class extends ei{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=_n,this.minFilter=_n,this.wrapR=is,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Oc=class extends ei{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=_n,this.minFilter=_n,this.wrapR=is,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var ah=class ah{constructor(e,t,i,s,r,o,a,l,c,u,d,h,m,g,_,f){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,d,h,m,g,_,f)}set(e,t,i,s,r,o,a,l,c,u,d,h,m,g,_,f){let p=this.elements;return p[0]=e,p[4]=t,p[8]=i,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=u,p[10]=d,p[14]=h,p[3]=m,p[7]=g,p[11]=_,p[15]=f,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new ah().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/yo.setFromMatrixColumn(e,0).length(),r=1/yo.setFromMatrixColumn(e,1).length(),o=1/yo.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),d=Math.sin(r);if(e.order==="XYZ"){let h=o*u,m=o*d,g=a*u,_=a*d;t[0]=l*u,t[4]=-l*d,t[8]=c,t[1]=m+g*c,t[5]=h-_*c,t[9]=-a*l,t[2]=_-h*c,t[6]=g+m*c,t[10]=o*l}else if(e.order==="YXZ"){let h=l*u,m=l*d,g=c*u,_=c*d;t[0]=h+_*a,t[4]=g*a-m,t[8]=o*c,t[1]=o*d,t[5]=o*u,t[9]=-a,t[2]=m*a-g,t[6]=_+h*a,t[10]=o*l}else if(e.order==="ZXY"){let h=l*u,m=l*d,g=c*u,_=c*d;t[0]=h-_*a,t[4]=-o*d,t[8]=g+m*a,t[1]=m+g*a,t[5]=o*u,t[9]=_-h*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let h=o*u,m=o*d,g=a*u,_=a*d;t[0]=l*u,t[4]=g*c-m,t[8]=h*c+_,t[1]=l*d,t[5]=_*c+h,t[9]=m*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let h=o*l,m=o*c,g=a*l,_=a*c;t[0]=l*u,t[4]=_-h*d,t[8]=g*d+m,t[1]=d,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=m*d+g,t[10]=h-_*d}else if(e.order==="XZY"){let h=o*l,m=o*c,g=a*l,_=a*c;t[0]=l*u,t[4]=-d,t[8]=c*u,t[1]=h*d+_,t[5]=o*u,t[9]=m*d-g,t[2]=g*d-m,t[6]=a*u,t[10]=_*d+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(FS,e,OS)}lookAt(e,t,i){let s=this.elements;return pi.subVectors(e,t),pi.lengthSq()===0&&(pi.z=1),pi.normalize(),Hs.crossVectors(i,pi),Hs.lengthSq()===0&&(Math.abs(i.z)===1?pi.x+=1e-4:pi.z+=1e-4,pi.normalize(),Hs.crossVectors(i,pi)),Hs.normalize(),ec.crossVectors(pi,Hs),s[0]=Hs.x,s[4]=ec.x,s[8]=pi.x,s[1]=Hs.y,s[5]=ec.y,s[9]=pi.y,s[2]=Hs.z,s[6]=ec.z,s[10]=pi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],d=i[5],h=i[9],m=i[13],g=i[2],_=i[6],f=i[10],p=i[14],v=i[3],P=i[7],b=i[11],C=i[15],M=s[0],x=s[4],y=s[8],L=s[12],R=s[1],I=s[5],U=s[9],k=s[13],E=s[2],N=s[6],z=s[10],O=s[14],X=s[3],H=s[7],Z=s[11],te=s[15];return r[0]=o*M+a*R+l*E+c*X,r[4]=o*x+a*I+l*N+c*H,r[8]=o*y+a*U+l*z+c*Z,r[12]=o*L+a*k+l*O+c*te,r[1]=u*M+d*R+h*E+m*X,r[5]=u*x+d*I+h*N+m*H,r[9]=u*y+d*U+h*z+m*Z,r[13]=u*L+d*k+h*O+m*te,r[2]=g*M+_*R+f*E+p*X,r[6]=g*x+_*I+f*N+p*H,r[10]=g*y+_*U+f*z+p*Z,r[14]=g*L+_*k+f*O+p*te,r[3]=v*M+P*R+b*E+C*X,r[7]=v*x+P*I+b*N+C*H,r[11]=v*y+P*U+b*z+C*Z,r[15]=v*L+P*k+b*O+C*te,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],d=e[6],h=e[10],m=e[14],g=e[3],_=e[7],f=e[11],p=e[15],v=l*m-c*h,P=a*m-c*d,b=a*h-l*d,C=o*m-c*u,M=o*h-l*u,x=o*d-a*u;return t*(_*v-f*P+p*b)-i*(g*v-f*C+p*M)+s*(g*P-_*C+p*x)-r*(g*b-_*M+f*x)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],d=e[9],h=e[10],m=e[11],g=e[12],_=e[13],f=e[14],p=e[15],v=t*a-i*o,P=t*l-s*o,b=t*c-r*o,C=i*l-s*a,M=i*c-r*a,x=s*c-r*l,y=u*_-d*g,L=u*f-h*g,R=u*p-m*g,I=d*f-h*_,U=d*p-m*_,k=h*p-m*f,E=v*k-P*U+b*I+C*R-M*L+x*y;if(E===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let N=1/E;return e[0]=(a*k-l*U+c*I)*N,e[1]=(s*U-i*k-r*I)*N,e[2]=(_*x-f*M+p*C)*N,e[3]=(h*M-d*x-m*C)*N,e[4]=(l*R-o*k-c*L)*N,e[5]=(t*k-s*R+r*L)*N,e[6]=(f*b-g*x-p*P)*N,e[7]=(u*x-h*b+m*P)*N,e[8]=(o*U-a*R+c*y)*N,e[9]=(i*R-t*U-r*y)*N,e[10]=(g*M-_*b+p*v)*N,e[11]=(d*b-u*M-m*v)*N,e[12]=(a*L-o*I-l*y)*N,e[13]=(t*I-i*L+s*y)*N,e[14]=(_*P-g*C-f*v)*N,e[15]=(u*C-d*P+h*v)*N,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,d=a+a,h=r*c,m=r*u,g=r*d,_=o*u,f=o*d,p=a*d,v=l*c,P=l*u,b=l*d,C=i.x,M=i.y,x=i.z;return s[0]=(1-(_+p))*C,s[1]=(m+b)*C,s[2]=(g-P)*C,s[3]=0,s[4]=(m-b)*M,s[5]=(1-(h+p))*M,s[6]=(f+v)*M,s[7]=0,s[8]=(g+P)*x,s[9]=(f-v)*x,s[10]=(1-(h+_))*x,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=yo.set(s[0],s[1],s[2]).length(),a=yo.set(s[4],s[5],s[6]).length(),l=yo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ui.copy(this);let c=1/o,u=1/a,d=1/l;return Ui.elements[0]*=c,Ui.elements[1]*=c,Ui.elements[2]*=c,Ui.elements[4]*=u,Ui.elements[5]*=u,Ui.elements[6]*=u,Ui.elements[8]*=d,Ui.elements[9]*=d,Ui.elements[10]*=d,t.setFromRotationMatrix(Ui),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Ei,l=!1){let c=this.elements,u=2*r/(t-e),d=2*r/(i-s),h=(t+e)/(t-e),m=(i+s)/(i-s),g,_;if(l)g=r/(o-r),_=o*r/(o-r);else if(a===Ei)g=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===Uo)g=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=d,c[9]=m,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Ei,l=!1){let c=this.elements,u=2/(t-e),d=2/(i-s),h=-(t+e)/(t-e),m=-(i+s)/(i-s),g,_;if(l)g=1/(o-r),_=o/(o-r);else if(a===Ei)g=-2/(o-r),_=-(o+r)/(o-r);else if(a===Uo)g=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=d,c[9]=0,c[13]=m,c[2]=0,c[6]=0,c[10]=g,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}};ah.prototype.isMatrix4=!0;var Bt=ah,yo=new Y,Ui=new Bt,FS=new Y(0,0,0),OS=new Y(1,1,1),Hs=new Y,ec=new Y,pi=new Y,Zg=new Bt,jg=new Qn,As=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],d=s[2],h=s[6],m=s[10];switch(t){case"XYZ":this._y=Math.asin(ct(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,m),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ct(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,m),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(ct(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-d,m),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ct(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(h,m),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ct(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,m));break;case"XZY":this._z=Math.asin(-ct(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,m),this._y=0);break;default:je("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return Zg.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Zg,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return jg.setFromEuler(this),this.setFromQuaternion(jg,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};As.DEFAULT_ORDER="XYZ";var Ua=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},BS=0,Jg=new Y,vo=new Qn,vs=new Bt,tc=new Y,Sa=new Y,kS=new Y,zS=new Qn,Kg=new Y(1,0,0),Qg=new Y(0,1,0),e0=new Y(0,0,1),t0={type:"added"},VS={type:"removed"},So={type:"childadded",child:null},Ed={type:"childremoved",child:null},Ln=class n extends ki{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:BS++}),this.uuid=rr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new Y,t=new As,i=new Qn,s=new Y(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Bt},normalMatrix:{value:new rt}}),this.matrix=new Bt,this.matrixWorld=new Bt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ua,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return vo.setFromAxisAngle(e,t),this.quaternion.multiply(vo),this}rotateOnWorldAxis(e,t){return vo.setFromAxisAngle(e,t),this.quaternion.premultiply(vo),this}rotateX(e){return this.rotateOnAxis(Kg,e)}rotateY(e){return this.rotateOnAxis(Qg,e)}rotateZ(e){return this.rotateOnAxis(e0,e)}translateOnAxis(e,t){return Jg.copy(e).applyQuaternion(this.quaternion),this.position.add(Jg.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Kg,e)}translateY(e){return this.translateOnAxis(Qg,e)}translateZ(e){return this.translateOnAxis(e0,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(vs.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?tc.copy(e):tc.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Sa.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?vs.lookAt(Sa,tc,this.up):vs.lookAt(tc,Sa,this.up),this.quaternion.setFromRotationMatrix(vs),s&&(vs.extractRotation(s.matrixWorld),vo.setFromRotationMatrix(vs),this.quaternion.premultiply(vo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(it("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(t0),So.child=e,this.dispatchEvent(So),So.child=null):it("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(VS),Ed.child=e,this.dispatchEvent(Ed),Ed.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),vs.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),vs.multiply(e.parent.matrixWorld)),e.applyMatrix4(vs),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(t0),So.child=e,this.dispatchEvent(So),So.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Sa,e,kS),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Sa,zS,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let d=l[c];r(e.shapes,d)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),d=o(e.shapes),h=o(e.skeletons),m=o(e.animations),g=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),d.length>0&&(i.shapes=d),h.length>0&&(i.skeletons=h),m.length>0&&(i.animations=m),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Ln.DEFAULT_UP=new Y(0,1,0);Ln.DEFAULT_MATRIX_AUTO_UPDATE=!0;Ln.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Jn=class extends Ln{constructor(){super(),this.isGroup=!0,this.type="Group"}},GS={type:"move"},ko=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Jn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Jn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new Y,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new Y),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Jn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new Y,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new Y,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let _ of e.hand.values()){let f=t.getJointPose(_,i),p=this._getHandJoint(c,_);f!==null&&(p.matrix.fromArray(f.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=f.radius),p.visible=f!==null}let u=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],h=u.position.distanceTo(d.position),m=.02,g=.005;c.inputState.pinching&&h>m+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&h<=m-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(GS)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Jn;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},i_={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ws={h:0,s:0,l:0},nc={h:0,s:0,l:0};function Td(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var ht=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Zn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,St.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=St.workingColorSpace){return this.r=e,this.g=t,this.b=i,St.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=St.workingColorSpace){if(e=wf(e,1),t=ct(t,0,1),i=ct(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=Td(o,r,e+1/3),this.g=Td(o,r,e),this.b=Td(o,r,e-1/3)}return St.colorSpaceToWorking(this,s),this}setStyle(e,t=Zn){function i(r){r!==void 0&&parseFloat(r)<1&&je("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:je("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);je("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Zn){let i=i_[e.toLowerCase()];return i!==void 0?this.setHex(i,t):je("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Es(e.r),this.g=Es(e.g),this.b=Es(e.b),this}copyLinearToSRGB(e){return this.r=Do(e.r),this.g=Do(e.g),this.b=Do(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Zn){return St.workingToColorSpace(kn.copy(this),e),Math.round(ct(kn.r*255,0,255))*65536+Math.round(ct(kn.g*255,0,255))*256+Math.round(ct(kn.b*255,0,255))}getHexString(e=Zn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=St.workingColorSpace){St.workingToColorSpace(kn.copy(this),t);let i=kn.r,s=kn.g,r=kn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=u<=.5?d/(o+a):d/(2-o-a),o){case i:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-i)/d+2;break;case r:l=(i-s)/d+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=St.workingColorSpace){return St.workingToColorSpace(kn.copy(this),t),e.r=kn.r,e.g=kn.g,e.b=kn.b,e}getStyle(e=Zn){St.workingToColorSpace(kn.copy(this),e);let t=kn.r,i=kn.g,s=kn.b;return e!==Zn?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Ws),this.setHSL(Ws.h+e,Ws.s+t,Ws.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Ws),e.getHSL(nc);let i=Ra(Ws.h,nc.h,t),s=Ra(Ws.s,nc.s,t),r=Ra(Ws.l,nc.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},kn=new ht;ht.NAMES=i_;var Fa=class extends Ln{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new As,this.environmentIntensity=1,this.environmentRotation=new As,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Fi=new Y,Ss=new Y,Ad=new Y,Ms=new Y,Mo=new Y,bo=new Y,n0=new Y,Rd=new Y,Cd=new Y,Pd=new Y,Id=new Dt,Ld=new Dt,Dd=new Dt,$s=class n{constructor(e=new Y,t=new Y,i=new Y){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Fi.subVectors(e,t),s.cross(Fi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Fi.subVectors(s,t),Ss.subVectors(i,t),Ad.subVectors(e,t);let o=Fi.dot(Fi),a=Fi.dot(Ss),l=Fi.dot(Ad),c=Ss.dot(Ss),u=Ss.dot(Ad),d=o*c-a*a;if(d===0)return r.set(0,0,0),null;let h=1/d,m=(c*l-a*u)*h,g=(o*u-a*l)*h;return r.set(1-m-g,g,m)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,Ms)===null?!1:Ms.x>=0&&Ms.y>=0&&Ms.x+Ms.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,Ms)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ms.x),l.addScaledVector(o,Ms.y),l.addScaledVector(a,Ms.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return Id.setScalar(0),Ld.setScalar(0),Dd.setScalar(0),Id.fromBufferAttribute(e,t),Ld.fromBufferAttribute(e,i),Dd.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Id,r.x),o.addScaledVector(Ld,r.y),o.addScaledVector(Dd,r.z),o}static isFrontFacing(e,t,i,s){return Fi.subVectors(i,t),Ss.subVectors(e,t),Fi.cross(Ss).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Fi.subVectors(this.c,this.b),Ss.subVectors(this.a,this.b),Fi.cross(Ss).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;Mo.subVectors(s,i),bo.subVectors(r,i),Rd.subVectors(e,i);let l=Mo.dot(Rd),c=bo.dot(Rd);if(l<=0&&c<=0)return t.copy(i);Cd.subVectors(e,s);let u=Mo.dot(Cd),d=bo.dot(Cd);if(u>=0&&d<=u)return t.copy(s);let h=l*d-u*c;if(h<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(Mo,o);Pd.subVectors(e,r);let m=Mo.dot(Pd),g=bo.dot(Pd);if(g>=0&&m<=g)return t.copy(r);let _=m*c-l*g;if(_<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(i).addScaledVector(bo,a);let f=u*g-m*d;if(f<=0&&d-u>=0&&m-g>=0)return n0.subVectors(r,s),a=(d-u)/(d-u+(m-g)),t.copy(s).addScaledVector(n0,a);let p=1/(f+_+h);return o=_*p,a=h*p,t.copy(i).addScaledVector(Mo,o).addScaledVector(bo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},xi=class{constructor(e=new Y(1/0,1/0,1/0),t=new Y(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Oi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Oi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Oi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Oi):Oi.fromBufferAttribute(r,o),Oi.applyMatrix4(e.matrixWorld),this.expandByPoint(Oi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),ic.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),ic.copy(i.boundingBox)),ic.applyMatrix4(e.matrixWorld),this.union(ic)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Oi),Oi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ma),sc.subVectors(this.max,Ma),wo.subVectors(e.a,Ma),Eo.subVectors(e.b,Ma),To.subVectors(e.c,Ma),qs.subVectors(Eo,wo),Xs.subVectors(To,Eo),Ar.subVectors(wo,To);let t=[0,-qs.z,qs.y,0,-Xs.z,Xs.y,0,-Ar.z,Ar.y,qs.z,0,-qs.x,Xs.z,0,-Xs.x,Ar.z,0,-Ar.x,-qs.y,qs.x,0,-Xs.y,Xs.x,0,-Ar.y,Ar.x,0];return!Nd(t,wo,Eo,To,sc)||(t=[1,0,0,0,1,0,0,0,1],!Nd(t,wo,Eo,To,sc))?!1:(rc.crossVectors(qs,Xs),t=[rc.x,rc.y,rc.z],Nd(t,wo,Eo,To,sc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Oi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Oi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(bs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),bs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),bs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),bs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),bs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),bs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),bs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),bs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(bs),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},bs=[new Y,new Y,new Y,new Y,new Y,new Y,new Y,new Y],Oi=new Y,ic=new xi,wo=new Y,Eo=new Y,To=new Y,qs=new Y,Xs=new Y,Ar=new Y,Ma=new Y,sc=new Y,rc=new Y,Rr=new Y;function Nd(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Rr.fromArray(n,r);let a=s.x*Math.abs(Rr.x)+s.y*Math.abs(Rr.y)+s.z*Math.abs(Rr.z),l=e.dot(Rr),c=t.dot(Rr),u=i.dot(Rr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var gn=new Y,oc=new Ke,HS=0,Bi=class extends ki{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:HS++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=Mf,this.updateRanges=[],this.gpuType=Hi,this.version=0,this._normalizationScale=e!==void 0?$h(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)oc.fromBufferAttribute(this,t),oc.applyMatrix3(e),this.setXY(t,oc.x,oc.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)gn.fromBufferAttribute(this,t),gn.applyMatrix3(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)gn.fromBufferAttribute(this,t),gn.applyMatrix4(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)gn.fromBufferAttribute(this,t),gn.applyNormalMatrix(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)gn.fromBufferAttribute(this,t),gn.transformDirection(e),this.setXYZ(t,gn.x,gn.y,gn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Tf(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Af(e,this.array)}};var Oa=class extends Bi{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var Ba=class extends Bi{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var Ht=class extends Bi{constructor(e,t,i){super(new Float32Array(e),t,i)}},WS=new xi,ba=new Y,Ud=new Y,zi=class{constructor(e=new Y,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):WS.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;ba.subVectors(e,this.center);let t=ba.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(ba,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Ud.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(ba.copy(e.center).add(Ud)),this.expandByPoint(ba.copy(e.center).sub(Ud))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},qS=0,wi=new Bt,Fd=new Ln,Ao=new Y,mi=new xi,wa=new xi,Cn=new Y,ii=class n extends ki{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:qS++}),this.uuid=rr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(gS(e)?Ba:Oa)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new rt().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return wi.makeRotationFromQuaternion(e),this.applyMatrix4(wi),this}rotateX(e){return wi.makeRotationX(e),this.applyMatrix4(wi),this}rotateY(e){return wi.makeRotationY(e),this.applyMatrix4(wi),this}rotateZ(e){return wi.makeRotationZ(e),this.applyMatrix4(wi),this}translate(e,t,i){return wi.makeTranslation(e,t,i),this.applyMatrix4(wi),this}scale(e,t,i){return wi.makeScale(e,t,i),this.applyMatrix4(wi),this}lookAt(e){return Fd.lookAt(e),Fd.updateMatrix(),this.applyMatrix4(Fd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ao).negate(),this.translate(Ao.x,Ao.y,Ao.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ht(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&je("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new xi);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){it("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new Y(-1/0,-1/0,-1/0),new Y(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];mi.setFromBufferAttribute(r),this.morphTargetsRelative?(Cn.addVectors(this.boundingBox.min,mi.min),this.boundingBox.expandByPoint(Cn),Cn.addVectors(this.boundingBox.max,mi.max),this.boundingBox.expandByPoint(Cn)):(this.boundingBox.expandByPoint(mi.min),this.boundingBox.expandByPoint(mi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&it('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new zi);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){it("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new Y,1/0);return}if(e){let i=this.boundingSphere.center;if(mi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];wa.setFromBufferAttribute(a),this.morphTargetsRelative?(Cn.addVectors(mi.min,wa.min),mi.expandByPoint(Cn),Cn.addVectors(mi.max,wa.max),mi.expandByPoint(Cn)):(mi.expandByPoint(wa.min),mi.expandByPoint(wa.max))}mi.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Cn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Cn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Cn.fromBufferAttribute(a,c),l&&(Ao.fromBufferAttribute(e,c),Cn.add(Ao)),s=Math.max(s,i.distanceToSquared(Cn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&it('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){it("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Bi(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let L=0;L<i.count;L++)a[L]=new Y,l[L]=new Y;let u=new Y,d=new Y,h=new Y,m=new Ke,g=new Ke,_=new Ke,f=new Y,p=new Y;function v(L,R,I){c[L]=c[R]=c[I]=1,u.fromBufferAttribute(i,L),d.fromBufferAttribute(i,R),h.fromBufferAttribute(i,I),m.fromBufferAttribute(r,L),g.fromBufferAttribute(r,R),_.fromBufferAttribute(r,I),d.sub(u),h.sub(u),g.sub(m),_.sub(m);let U=1/(g.x*_.y-_.x*g.y);isFinite(U)&&(f.copy(d).multiplyScalar(_.y).addScaledVector(h,-g.y).multiplyScalar(U),p.copy(h).multiplyScalar(g.x).addScaledVector(d,-_.x).multiplyScalar(U),a[L].add(f),a[R].add(f),a[I].add(f),l[L].add(p),l[R].add(p),l[I].add(p))}let P=this.groups;P.length===0&&(P=[{start:0,count:e.count}]);for(let L=0,R=P.length;L<R;++L){let I=P[L],U=I.start,k=I.count;for(let E=U,N=U+k;E<N;E+=3)v(e.getX(E+0),e.getX(E+1),e.getX(E+2))}let b=new Y,C=new Y,M=new Y,x=new Y;function y(L){M.fromBufferAttribute(s,L),x.copy(M);let R=a[L];b.copy(R),b.sub(M.multiplyScalar(M.dot(R))).normalize(),C.crossVectors(x,R);let U=C.dot(l[L])<0?-1:1;o.setXYZW(L,b.x,b.y,b.z,U)}for(let L=0,R=i.count;L<R;++L)c[L]&&y(L);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new Bi(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let h=0,m=i.count;h<m;h++)i.setXYZ(h,0,0,0);let s=new Y,r=new Y,o=new Y,a=new Y,l=new Y,c=new Y,u=new Y,d=new Y;if(e)for(let h=0,m=e.count;h<m;h+=3){let g=e.getX(h+0),_=e.getX(h+1),f=e.getX(h+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,_),o.fromBufferAttribute(t,f),u.subVectors(o,r),d.subVectors(s,r),u.cross(d),a.fromBufferAttribute(i,g),l.fromBufferAttribute(i,_),c.fromBufferAttribute(i,f),a.add(u),l.add(u),c.add(u),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(_,l.x,l.y,l.z),i.setXYZ(f,c.x,c.y,c.z)}else for(let h=0,m=t.count;h<m;h+=3)s.fromBufferAttribute(t,h+0),r.fromBufferAttribute(t,h+1),o.fromBufferAttribute(t,h+2),u.subVectors(o,r),d.subVectors(s,r),u.cross(d),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Cn.fromBufferAttribute(e,t),Cn.normalize(),e.setXYZ(t,Cn.x,Cn.y,Cn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,d=a.normalized,h=new c.constructor(l.length*u),m=0,g=0;for(let _=0,f=l.length;_<f;_++){a.isInterleavedBufferAttribute?m=l[_]*a.data.stride+a.offset:m=l[_]*u;for(let p=0;p<u;p++)h[g++]=c[m++]}return new Bi(h,u,d)}if(this.index===null)return je("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,d=c.length;u<d;u++){let h=c[u],m=e(h,i);l.push(m)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let d=0,h=c.length;d<h;d++){let m=c[d];u.push(m.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],d=r[c];for(let h=0,m=d.length;h<m;h++)u.push(d[h].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Bc=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=Mf,this.updateRanges=[],this.version=0,this.uuid=rr()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,i){e*=this.stride,i*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[i+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=i0(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let i=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=i0(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function i0(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=rr()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var $n=new Y,Vi=class n{constructor(e,t,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=i,this.normalized=s,this._normalizationScale=e!==void 0?$h(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,i=this.data.count;t<i;t++)$n.fromBufferAttribute(this,t),$n.applyMatrix4(e),this.setXYZ(t,$n.x,$n.y,$n.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)$n.fromBufferAttribute(this,t),$n.applyNormalMatrix(e),this.setXYZ(t,$n.x,$n.y,$n.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)$n.fromBufferAttribute(this,t),$n.transformDirection(e),this.setXYZ(t,$n.x,$n.y,$n.z);return this}getComponent(e,t){let i=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.data.array[e*this.data.stride+this.offset+t]=i,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,i){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.data.array[e+0]=t,this.data.array[e+1]=i,this}setXYZ(e,t,i,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){Da("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new Bi(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new n(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){Da("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Tf(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Af(e,this.data.array)}},Od=new Y,XS=new Y,YS=new rt,gi=class{constructor(e=new Y(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=Od.subVectors(i,t).cross(XS.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(Od),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||YS.getNormalMatrix(e),s=this.coplanarPoint(Od).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},$S=0,ss=class extends ki{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:$S++}),this.uuid=rr(),this.name="",this.type="Material",this.blending=qo,this.side=ir,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=ef,this.blendDst=tf,this.blendEquation=Nr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ht(0,0,0),this.blendAlpha=0,this.depthFunc=No,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Y0,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=wc,this.stencilZFail=wc,this.stencilZPass=wc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){je(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){je(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new ht().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new gi().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Ke().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ke().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var ws=new Y,Bd=new Y,ac=new Y,lc=new Y,Ir=class{constructor(e=new Y,t=new Y(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ws)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=ws.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ws.copy(this.origin).addScaledVector(this.direction,t),ws.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){Bd.copy(e).add(t).multiplyScalar(.5),ac.copy(t).sub(e).normalize(),lc.copy(this.origin).sub(Bd);let r=e.distanceTo(t)*.5,o=-this.direction.dot(ac),a=lc.dot(this.direction),l=-lc.dot(ac),c=lc.lengthSq(),u=Math.abs(1-o*o),d,h,m,g;if(u>0)if(d=o*l-a,h=o*a-l,g=r*u,d>=0)if(h>=-g)if(h<=g){let _=1/u;d*=_,h*=_,m=d*(d+o*h+2*a)+h*(o*d+h+2*l)+c}else h=r,d=Math.max(0,-(o*h+a)),m=-d*d+h*(h+2*l)+c;else h=-r,d=Math.max(0,-(o*h+a)),m=-d*d+h*(h+2*l)+c;else h<=-g?(d=Math.max(0,-(-o*r+a)),h=d>0?-r:Math.min(Math.max(-r,-l),r),m=-d*d+h*(h+2*l)+c):h<=g?(d=0,h=Math.min(Math.max(-r,-l),r),m=h*(h+2*l)+c):(d=Math.max(0,-(o*r+a)),h=d>0?r:Math.min(Math.max(-r,-l),r),m=-d*d+h*(h+2*l)+c);else h=o>0?-r:r,d=Math.max(0,-(o*h+a)),m=-d*d+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(Bd).addScaledVector(ac,h),m}intersectSphere(e,t){if(e.radius<0)return null;ws.subVectors(e.center,this.origin);let i=ws.dot(this.direction),s=ws.dot(ws)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,d=1/this.direction.z,h=this.origin;return c>=0?(i=(e.min.x-h.x)*c,s=(e.max.x-h.x)*c):(i=(e.max.x-h.x)*c,s=(e.min.x-h.x)*c),u>=0?(r=(e.min.y-h.y)*u,o=(e.max.y-h.y)*u):(r=(e.max.y-h.y)*u,o=(e.min.y-h.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(e.min.z-h.z)*d,l=(e.max.z-h.z)*d):(a=(e.max.z-h.z)*d,l=(e.min.z-h.z)*d),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,ws)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,d=e.x-o.x,h=e.y-o.y,m=e.z-o.z,g=t.x-o.x,_=t.y-o.y,f=t.z-o.z,p=i.x-o.x,v=i.y-o.y,P=i.z-o.z,b=Math.abs(l),C=Math.abs(c),M=Math.abs(u),x,y,L,R,I,U,k,E,N,z,O,X;if(b>=C&&b>=M?(L=l,U=d,N=g,X=p,l>=0?(x=c,y=u,R=h,I=m,k=_,E=f,z=v,O=P):(x=u,y=c,R=m,I=h,k=f,E=_,z=P,O=v)):C>=M?(L=c,U=h,N=_,X=v,c>=0?(x=u,y=l,R=m,I=d,k=f,E=g,z=P,O=p):(x=l,y=u,R=d,I=m,k=g,E=f,z=p,O=P)):(L=u,U=m,N=f,X=P,u>=0?(x=l,y=c,R=d,I=h,k=g,E=_,z=p,O=v):(x=c,y=l,R=h,I=d,k=_,E=g,z=v,O=p)),L===0)return null;let H=x/L,Z=y/L,te=1/L,le=R-H*U,he=I-Z*U,Q=k-H*N,me=E-Z*N,ge=z-H*X,oe=O-Z*X,de=ge*me-oe*Q,Ne=le*oe-he*ge,Ye=Q*he-me*le;if(s){if(de<0||Ne<0||Ye<0)return null}else if((de<0||Ne<0||Ye<0)&&(de>0||Ne>0||Ye>0))return null;let Be=de+Ne+Ye;if(Be===0)return null;let st=te*(de*U+Ne*N+Ye*X);return(Be>0?st<0:st>0)?null:this.at(st/Be,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},kc=class extends ss{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ht(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new As,this.combine=nf,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},s0=new Bt,Cr=new Ir,cc=new zi,r0=new Y,hc=new Y,uc=new Y,dc=new Y,kd=new Y,fc=new Y,o0=new Y,pc=new Y,zn=class extends Ln{constructor(e=new ii,t=new kc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){fc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],d=r[l];u!==0&&(kd.fromBufferAttribute(d,e),o?fc.addScaledVector(kd,u):fc.addScaledVector(kd.sub(t),u))}t.add(fc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),cc.copy(i.boundingSphere),cc.applyMatrix4(r),Cr.copy(e.ray).recast(e.near),!(cc.containsPoint(Cr.origin)===!1&&(Cr.intersectSphere(cc,r0)===null||Cr.origin.distanceToSquared(r0)>(e.far-e.near)**2))&&(s0.copy(r).invert(),Cr.copy(e.ray).applyMatrix4(s0),!(i.boundingBox!==null&&Cr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Cr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,d=r.attributes.normal,h=r.groups,m=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,_=h.length;g<_;g++){let f=h[g],p=o[f.materialIndex],v=Math.max(f.start,m.start),P=Math.min(a.count,Math.min(f.start+f.count,m.start+m.count));for(let b=v,C=P;b<C;b+=3){let M=a.getX(b),x=a.getX(b+1),y=a.getX(b+2);s=mc(this,p,e,i,c,u,d,M,x,y),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=f.materialIndex,t.push(s))}}else{let g=Math.max(0,m.start),_=Math.min(a.count,m.start+m.count);for(let f=g,p=_;f<p;f+=3){let v=a.getX(f),P=a.getX(f+1),b=a.getX(f+2);s=mc(this,o,e,i,c,u,d,v,P,b),s&&(s.faceIndex=Math.floor(f/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,_=h.length;g<_;g++){let f=h[g],p=o[f.materialIndex],v=Math.max(f.start,m.start),P=Math.min(l.count,Math.min(f.start+f.count,m.start+m.count));for(let b=v,C=P;b<C;b+=3){let M=b,x=b+1,y=b+2;s=mc(this,p,e,i,c,u,d,M,x,y),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=f.materialIndex,t.push(s))}}else{let g=Math.max(0,m.start),_=Math.min(l.count,m.start+m.count);for(let f=g,p=_;f<p;f+=3){let v=f,P=f+1,b=f+2;s=mc(this,o,e,i,c,u,d,v,P,b),s&&(s.faceIndex=Math.floor(f/3),t.push(s))}}}};function ZS(n,e,t,i,s,r,o,a){let l;if(e.side===ti?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===ir,a),l===null)return null;pc.copy(a),pc.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(pc);return c<t.near||c>t.far?null:{distance:c,point:pc.clone(),object:n}}function mc(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,hc),n.getVertexPosition(l,uc),n.getVertexPosition(c,dc);let u=ZS(n,e,t,i,hc,uc,dc,o0);if(u){let d=new Y;$s.getBarycoord(o0,hc,uc,dc,d),s&&(u.uv=$s.getInterpolatedAttribute(s,a,l,c,d,new Ke)),r&&(u.uv1=$s.getInterpolatedAttribute(r,a,l,c,d,new Ke)),o&&(u.normal=$s.getInterpolatedAttribute(o,a,l,c,d,new Y),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new Y,materialIndex:0};$s.getNormal(hc,uc,dc,h.normal),u.face=h,u.barycoord=d}return u}var zc=class extends ei{constructor(e=null,t=1,i=1,s,r,o,a,l,c=_n,u=_n,d,h){super(null,o,a,l,c,u,s,r,d,h),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Pr=new zi,jS=new Ke(.5,.5),gc=new Y,Zs=class{constructor(e=new gi,t=new gi,i=new gi,s=new gi,r=new gi,o=new gi){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Ei,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],d=r[5],h=r[6],m=r[7],g=r[8],_=r[9],f=r[10],p=r[11],v=r[12],P=r[13],b=r[14],C=r[15];if(s[0].setComponents(c-o,m-u,p-g,C-v).normalize(),s[1].setComponents(c+o,m+u,p+g,C+v).normalize(),s[2].setComponents(c+a,m+d,p+_,C+P).normalize(),s[3].setComponents(c-a,m-d,p-_,C-P).normalize(),i)s[4].setComponents(l,h,f,b).normalize(),s[5].setComponents(c-l,m-h,p-f,C-b).normalize();else if(s[4].setComponents(c-l,m-h,p-f,C-b).normalize(),t===Ei)s[5].setComponents(c+l,m+h,p+f,C+b).normalize();else if(t===Uo)s[5].setComponents(l,h,f,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Pr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Pr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Pr)}intersectsSprite(e){Pr.center.set(0,0,0);let t=jS.distanceTo(e.center);return Pr.radius=.7071067811865476+t,Pr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Pr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(gc.x=s.normal.x>0?e.max.x:e.min.x,gc.y=s.normal.y>0?e.max.y:e.min.y,gc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(gc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},a0=new Bt,Vc=class n{constructor(){this.coordinateSystem=Ei,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];a0.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Zs),i[s].setFromProjectionMatrix(a0,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Zs),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var ka=class extends ss{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ht(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Gc=new Y,Hc=new Y,l0=new Bt,Ea=new Ir,_c=new zi,zd=new Y,c0=new Y,Wc=class extends Ln{constructor(e=new ii,t=new ka){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)Gc.fromBufferAttribute(t,s-1),Hc.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=Gc.distanceTo(Hc);e.setAttribute("lineDistance",new Ht(i,1))}else je("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),_c.copy(i.boundingSphere),_c.applyMatrix4(s),_c.radius+=r,e.ray.intersectsSphere(_c)===!1)return;l0.copy(s).invert(),Ea.copy(e.ray).applyMatrix4(l0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,h=i.attributes.position;if(u!==null){let m=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let _=m,f=g-1;_<f;_+=c){let p=u.getX(_),v=u.getX(_+1),P=xc(this,e,Ea,l,p,v,_);P&&t.push(P)}if(this.isLineLoop){let _=u.getX(g-1),f=u.getX(m),p=xc(this,e,Ea,l,_,f,g-1);p&&t.push(p)}}else{let m=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let _=m,f=g-1;_<f;_+=c){let p=xc(this,e,Ea,l,_,_+1,_);p&&t.push(p)}if(this.isLineLoop){let _=xc(this,e,Ea,l,g-1,m,g-1);_&&t.push(_)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function xc(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(Gc.fromBufferAttribute(a,s),Hc.fromBufferAttribute(a,r),t.distanceSqToSegment(Gc,Hc,zd,c0)>i)return;zd.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(zd);if(!(c<e.near||c>e.far))return{distance:c,point:c0.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var h0=new Y,u0=new Y,qc=class extends Wc{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)h0.fromBufferAttribute(t,s),u0.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+h0.distanceTo(u0);e.setAttribute("lineDistance",new Ht(i,1))}else je("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var za=class extends ei{constructor(e=[],t=Ur,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},Va=class extends ei{constructor(e,t,i,s,r,o,a,l,c){super(e,t,i,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Rs=class extends ei{constructor(e,t,i=Gi,s,r,o,a=_n,l=_n,c,u=Ts,d=1){if(u!==Ts&&u!==Ps)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:e,height:t,depth:d};super(h,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Bo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Ga=class extends Rs{constructor(e,t=Gi,i=Ur,s,r,o=_n,a=_n,l,c=Ts){let u={width:e,height:e,depth:1},d=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Ha=class extends ei{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},js=class n extends ii{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],d=[],h=0,m=0;g("z","y","x",-1,-1,i,t,e,o,r,0),g("z","y","x",1,-1,i,t,-e,o,r,1),g("x","z","y",1,1,e,i,t,s,o,2),g("x","z","y",1,-1,e,i,-t,s,o,3),g("x","y","z",1,-1,e,t,i,s,r,4),g("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Ht(c,3)),this.setAttribute("normal",new Ht(u,3)),this.setAttribute("uv",new Ht(d,2));function g(_,f,p,v,P,b,C,M,x,y,L){let R=b/x,I=C/y,U=b/2,k=C/2,E=M/2,N=x+1,z=y+1,O=0,X=0,H=new Y;for(let Z=0;Z<z;Z++){let te=Z*I-k;for(let le=0;le<N;le++){let he=le*R-U;H[_]=he*v,H[f]=te*P,H[p]=E,c.push(H.x,H.y,H.z),H[_]=0,H[f]=0,H[p]=M>0?1:-1,u.push(H.x,H.y,H.z),d.push(le/x),d.push(1-Z/y),O+=1}}for(let Z=0;Z<y;Z++)for(let te=0;te<x;te++){let le=h+te+N*Z,he=h+te+N*(Z+1),Q=h+(te+1)+N*(Z+1),me=h+(te+1)+N*Z;l.push(le,he,me),l.push(he,Q,me),X+=6}a.addGroup(m,X,L),m+=X,h+=O}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var zo=class n extends ii{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],d=[],h=[],m=[],g=0,_=[],f=i/2,p=0;v(),o===!1&&(e>0&&P(!0),t>0&&P(!1)),this.setIndex(u),this.setAttribute("position",new Ht(d,3)),this.setAttribute("normal",new Ht(h,3)),this.setAttribute("uv",new Ht(m,2));function v(){let b=new Y,C=new Y,M=0,x=(t-e)/i;for(let y=0;y<=r;y++){let L=[],R=y/r,I=R*(t-e)+e;for(let U=0;U<=s;U++){let k=U/s,E=k*l+a,N=Math.sin(E),z=Math.cos(E);C.x=I*N,C.y=-R*i+f,C.z=I*z,d.push(C.x,C.y,C.z),b.set(N,x,z).normalize(),h.push(b.x,b.y,b.z),m.push(k,1-R),L.push(g++)}_.push(L)}for(let y=0;y<s;y++)for(let L=0;L<r;L++){let R=_[L][y],I=_[L+1][y],U=_[L+1][y+1],k=_[L][y+1];(e>0||L!==0)&&(u.push(R,I,k),M+=3),(t>0||L!==r-1)&&(u.push(I,U,k),M+=3)}c.addGroup(p,M,0),p+=M}function P(b){let C=g,M=new Ke,x=new Y,y=0,L=b===!0?e:t,R=b===!0?1:-1;for(let U=1;U<=s;U++)d.push(0,f*R,0),h.push(0,R,0),m.push(.5,.5),g++;let I=g;for(let U=0;U<=s;U++){let E=U/s*l+a,N=Math.cos(E),z=Math.sin(E);x.x=L*z,x.y=f*R,x.z=L*N,d.push(x.x,x.y,x.z),h.push(0,R,0),M.x=N*.5+.5,M.y=z*.5*R+.5,m.push(M.x,M.y),g++}for(let U=0;U<s;U++){let k=C+U,E=I+U;b===!0?u.push(E,E+1,k):u.push(E+1,E,k),y+=3}c.addGroup(p,y,b===!0?1:2),p+=y}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Wa=class n extends zo{constructor(e=1,t=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new n(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Lr=class n extends ii{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,d=e/a,h=t/l,m=[],g=[],_=[],f=[];for(let p=0;p<u;p++){let v=p*h-o;for(let P=0;P<c;P++){let b=P*d-r;g.push(b,-v,0),_.push(0,0,1),f.push(P/a),f.push(1-p/l)}}for(let p=0;p<l;p++)for(let v=0;v<a;v++){let P=v+c*p,b=v+c*(p+1),C=v+1+c*(p+1),M=v+1+c*p;m.push(P,b,M),m.push(b,C,M)}this.setIndex(m),this.setAttribute("position",new Ht(g,3)),this.setAttribute("normal",new Ht(_,3)),this.setAttribute("uv",new Ht(f,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var qa=class n extends ii{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],d=new Y,h=new Y,m=[],g=[],_=[],f=[];for(let p=0;p<=i;p++){let v=[],P=p/i,b=o+P*a,C=e*Math.cos(b),M=Math.sqrt(e*e-C*C),x=0;p===0&&o===0?x=.5/t:p===i&&l===Math.PI&&(x=-.5/t);for(let y=0;y<=t;y++){let L=y/t,R=s+L*r;d.x=-M*Math.cos(R),d.y=C,d.z=M*Math.sin(R),g.push(d.x,d.y,d.z),h.copy(d).normalize(),_.push(h.x,h.y,h.z),f.push(L+x,1-P),v.push(c++)}u.push(v)}for(let p=0;p<i;p++)for(let v=0;v<t;v++){let P=u[p][v+1],b=u[p][v],C=u[p+1][v],M=u[p+1][v+1];(p!==0||o>0)&&m.push(P,b,M),(p!==i-1||l<Math.PI)&&m.push(b,C,M)}this.setIndex(m),this.setAttribute("position",new Ht(g,3)),this.setAttribute("normal",new Ht(_,3)),this.setAttribute("uv",new Ht(f,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var Xa=class extends ii{constructor(e=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:e},e!==null){let t=[],i=new Set,s=new Y,r=new Y;if(e.index!==null){let o=e.attributes.position,a=e.index,l=e.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,u=l.length;c<u;++c){let d=l[c],h=d.start,m=d.count;for(let g=h,_=h+m;g<_;g+=3)for(let f=0;f<3;f++){let p=a.getX(g+f),v=a.getX(g+(f+1)%3);s.fromBufferAttribute(o,p),r.fromBufferAttribute(o,v),d0(s,r,i)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}}else{let o=e.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let u=3*a+c,d=3*a+(c+1)%3;s.fromBufferAttribute(o,u),r.fromBufferAttribute(o,d),d0(s,r,i)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}this.setAttribute("position",new Ht(t,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};function d0(n,e,t){let i=`${n.x},${n.y},${n.z}-${e.x},${e.y},${e.z}`,s=`${e.x},${e.y},${e.z}-${n.x},${n.y},${n.z}`;return t.has(i)===!0||t.has(s)===!0?!1:(t.add(i),t.add(s),!0)}var Ya=class extends ss{constructor(e){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new ht(0),this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.fog=e.fog,this}};function Or(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(f0(s))s.isRenderTargetTexture?(je("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(f0(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function Vn(n){let e={};for(let t=0;t<n.length;t++){let i=Or(n[t]);for(let s in i)e[s]=i[s]}return e}function f0(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function JS(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Rf(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:St.workingColorSpace}var fl={clone:Or,merge:Vn},KS=`void main() {
gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,QS=`void main() {
gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ti=class extends ss{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=KS,this.fragmentShader=QS,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Or(e.uniforms),this.uniformsGroups=JS(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new ht().setHex(s.value);break;case"v2":this.uniforms[i].value=new Ke().fromArray(s.value);break;case"v3":this.uniforms[i].value=new Y().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Dt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new rt().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Bt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Xc=class extends Ti{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},Vo=class extends ss{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new ht(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ht(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Yh,this.normalScale=new Ke(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new As,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var Yc=class extends ss{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=q0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},$c=class extends ss{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Ro(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function yc(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Js=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break e}o=i,i=0;break t}break n}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Zc=class extends Js{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Wd,endingEnd:Wd}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case qd:r=e,a=2*t-i;break;case Xd:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case qd:o=e,l=2*i-t;break;case Xd:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,d=this._offsetNext,h=this._weightPrev,m=this._weightNext,g=(i-t)/(s-t),_=g*g,f=_*g,p=-h*f+2*h*_-h*g,v=(1+h)*f+(-1.5-2*h)*_+(-.5+h)*g+1,P=(-1-m)*f+(1.5+m)*_+.5*g,b=m*f-m*_;for(let C=0;C!==a;++C)r[C]=p*o[u+C]+v*o[c+C]+P*o[l+C]+b*o[d+C];return r}},jc=class extends Js{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),d=1-u;for(let h=0;h!==a;++h)r[h]=o[c+h]*d+o[l+h]*u;return r}},Jc=class extends Js{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Kc=class extends Js{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,d=this.outTangents;if(!u||!d){let g=(i-t)/(s-t),_=1-g;for(let f=0;f!==a;++f)r[f]=o[c+f]*_+o[l+f]*g;return r}let h=a*2,m=e-1;for(let g=0;g!==a;++g){let _=o[c+g],f=o[l+g],p=m*h+g*2,v=d[p],P=d[p+1],b=e*h+g*2,C=u[b],M=u[b+1],x=tM(i,t,v,C,s);r[g]=s_(x,_,P,M,f)}return r}};function s_(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function eM(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function tM(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=s_(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=eM(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var yi=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Ro(t,this.TimeBufferType),this.values=Ro(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:Ro(e.times,Array),values:Ro(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),yc(e.settings)&&(i.settings={inTangents:Ro(e.settings.inTangents,Array),outTangents:Ro(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new Jc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new jc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Zc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Kc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Ca:t=this.InterpolantFactoryMethodDiscrete;break;case Nc:t=this.InterpolantFactoryMethodLinear;break;case bc:t=this.InterpolantFactoryMethodSmooth;break;case Hd:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return je("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ca;case this.InterpolantFactoryMethodLinear:return Nc;case this.InterpolantFactoryMethodSmooth:return bc;case this.InterpolantFactoryMethodBezier:return Hd}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;yc(this.settings)&&(p0(this.settings.inTangents,e),p0(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;yc(this.settings)&&(m0(this.settings.inTangents,e),m0(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(it("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(it("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){it("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){it("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&_S(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){it("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===bc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let d=a*i,h=d-i,m=d+i;for(let g=0;g!==i;++g){let _=t[d+g];if(_!==t[h+g]||_!==t[m+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let d=a*i,h=o*i;for(let m=0;m!==i;++m)t[h+m]=t[d+m]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,yc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function p0(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function m0(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}yi.prototype.ValueTypeName="";yi.prototype.TimeBufferType=Float32Array;yi.prototype.ValueBufferType=Float32Array;yi.prototype.DefaultInterpolation=Nc;var Ks=class extends yi{constructor(e,t,i){super(e,t,i)}};Ks.prototype.ValueTypeName="bool";Ks.prototype.ValueBufferType=Array;Ks.prototype.DefaultInterpolation=Ca;Ks.prototype.InterpolantFactoryMethodLinear=void 0;Ks.prototype.InterpolantFactoryMethodSmooth=void 0;var Qc=class extends yi{constructor(e,t,i,s){super(e,t,i,s)}};Qc.prototype.ValueTypeName="color";var eh=class extends yi{constructor(e,t,i,s){super(e,t,i,s)}};eh.prototype.ValueTypeName="number";var th=class extends Js{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)Qn.slerpFlat(r,0,o,c-a,o,c,l);return r}},$a=class extends yi{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new th(this.times,this.values,this.getValueSize(),e)}};$a.prototype.ValueTypeName="quaternion";$a.prototype.InterpolantFactoryMethodSmooth=void 0;var Qs=class extends yi{constructor(e,t,i){super(e,t,i)}};Qs.prototype.ValueTypeName="string";Qs.prototype.ValueBufferType=Array;Qs.prototype.DefaultInterpolation=Ca;Qs.prototype.InterpolantFactoryMethodLinear=void 0;Qs.prototype.InterpolantFactoryMethodSmooth=void 0;var nh=class extends yi{constructor(e,t,i,s){super(e,t,i,s)}};nh.prototype.ValueTypeName="vector";var ih=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,d){return c.push(u,d),this},this.removeHandler=function(u){let d=c.indexOf(u);return d!==-1&&c.splice(d,2),this},this.getHandler=function(u){for(let d=0,h=c.length;d<h;d+=2){let m=c[d],g=c[d+1];if(m.global&&(m.lastIndex=0),m.test(u))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},r_=new ih,sh=class{constructor(e){this.manager=e!==void 0?e:r_,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};sh.DEFAULT_MATERIAL_NAME="__DEFAULT";var Za=class extends Ln{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new ht(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},ja=class extends Za{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Ln.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ht(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},Vd=new Bt,g0=new Y,_0=new Y,rh=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ke(512,512),this.mapType=si,this.map=null,this.mapPass=null,this.matrix=new Bt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Zs,this._frameExtents=new Ke(1,1),this._viewportCount=1,this._viewports=[new Dt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;g0.setFromMatrixPosition(e.matrixWorld),t.position.copy(g0),_0.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(_0),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){Vd.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(Vd,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Uo||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(Vd)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},vc=new Y,Sc=new Qn,ns=new Y,Ja=class extends Ln{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Bt,this.projectionMatrix=new Bt,this.projectionMatrixInverse=new Bt,this.coordinateSystem=Ei,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(vc,Sc,ns),ns.x===1&&ns.y===1&&ns.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(vc,Sc,ns.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(vc,Sc,ns),ns.x===1&&ns.y===1&&ns.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(vc,Sc,ns.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Ys=new Y,x0=new Ke,y0=new Ke,jn=class extends Ja{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Oo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Aa*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Oo*2*Math.atan(Math.tan(Aa*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Ys.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Ys.x,Ys.y).multiplyScalar(-e/Ys.z),Ys.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Ys.x,Ys.y).multiplyScalar(-e/Ys.z)}getViewSize(e,t){return this.getViewBounds(e,x0,y0),t.subVectors(y0,x0)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Aa*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Ka=class extends Ja{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Yd=class extends rh{constructor(){super(new Ka(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Qa=class extends Za{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Ln.DEFAULT_UP),this.updateMatrix(),this.target=new Ln,this.shadow=new Yd}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var el=class extends ii{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Co=-90,Po=1,Go=class extends Ln{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new jn(Co,Po,e,t);s.layers=this.layers,this.add(s);let r=new jn(Co,Po,e,t);r.layers=this.layers,this.add(r);let o=new jn(Co,Po,e,t);o.layers=this.layers,this.add(o);let a=new jn(Co,Po,e,t);a.layers=this.layers,this.add(a);let l=new jn(Co,Po,e,t);l.layers=this.layers,this.add(l);let c=new jn(Co,Po,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Ei)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Uo)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,d=e.getRenderTarget(),h=e.getActiveCubeFace(),m=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let _=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let f=!1;e.isWebGLRenderer===!0?f=e.state.buffers.depth.getReversed():f=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=_,e.setRenderTarget(i,5,s),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(d,h,m),e.xr.enabled=g,i.texture.needsPMREMUpdate=!0}},oh=class extends jn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Cf="\\[\\]\\.:\\/",nM=new RegExp("["+Cf+"]","g"),Pf="[^"+Cf+"]",iM="[^"+Cf.replace("\\.","")+"]",sM=/((?:WC+[\/:])*)/.source.replace("WC",Pf),rM=/(WCOD+)?/.source.replace("WCOD",iM),oM=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Pf),aM=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Pf),lM=new RegExp("^"+sM+rM+oM+aM+"$"),cM=["material","materials","bones","map"],$d=class{constructor(e,t,i){let s=i||Zt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},Zt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(nM,"")}static parseTrackName(e){let t=lM.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);cM.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){je("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){it("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){it("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){it("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){it("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){it("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){it("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){it("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;it("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){it("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){it("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Zt.Composite=$d;Zt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Zt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Zt.prototype.GetterByBindingType=[Zt.prototype._getValue_direct,Zt.prototype._getValue_array,Zt.prototype._getValue_arrayElement,Zt.prototype._getValue_toArray];Zt.prototype.SetterByBindingTypeAndVersioning=[[Zt.prototype._setValue_direct,Zt.prototype._setValue_direct_setNeedsUpdate,Zt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_array,Zt.prototype._setValue_array_setNeedsUpdate,Zt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_arrayElement,Zt.prototype._setValue_arrayElement_setNeedsUpdate,Zt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_fromArray,Zt.prototype._setValue_fromArray_setNeedsUpdate,Zt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var wR=new Float32Array(1);var er=class extends Bc{constructor(e,t,i=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=i}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var Ho=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=ct(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(ct(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Ff=class Ff{constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};Ff.prototype.isMatrix2=!0;var Zd=Ff;var v0=new Y,Mc=new Y,Io=new Y,Lo=new Y,Gd=new Y,hM=new Y,uM=new Y,tl=class{constructor(e=new Y,t=new Y){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){v0.subVectors(e,this.start),Mc.subVectors(this.end,this.start);let i=Mc.dot(Mc);if(i===0)return 0;let r=Mc.dot(v0)/i;return t&&(r=ct(r,0,1)),r}closestPointToPoint(e,t,i){let s=this.closestPointToPointParameter(e,t);return this.delta(i).multiplyScalar(s).add(this.start)}distanceSqToLine3(e,t=hM,i=uM){let s=10000000000000001e-32,r,o,a=this.start,l=e.start,c=this.end,u=e.end;Io.subVectors(c,a),Lo.subVectors(u,l),Gd.subVectors(a,l);let d=Io.dot(Io),h=Lo.dot(Lo),m=Lo.dot(Gd);if(d<=s&&h<=s)return t.copy(a),i.copy(l),t.distanceToSquared(i);if(d<=s)r=0,o=m/h,o=ct(o,0,1);else{let g=Io.dot(Gd);if(h<=s)o=0,r=ct(-g/d,0,1);else{let _=Io.dot(Lo),f=d*h-_*_;f!==0?r=ct((_*m-g*h)/f,0,1):r=0,o=(_*r+m)/h,o<0?(o=0,r=ct(-g/d,0,1)):o>1&&(o=1,r=ct((_-g)/d,0,1))}}return t.copy(a).addScaledVector(Io,r),i.copy(l).addScaledVector(Lo,o),t.distanceToSquared(i)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var nl=class extends qc{constructor(e=10,t=10,i=4473924,s=8947848){i=new ht(i),s=new ht(s);let r=t/2,o=e/t,a=e/2,l=[],c=[];for(let h=0,m=0,g=-a;h<=t;h++,g+=o){l.push(-a,0,g,a,0,g),l.push(g,0,-a,g,0,a);let _=h===r?i:s;_.toArray(c,m),m+=3,_.toArray(c,m),m+=3,_.toArray(c,m),m+=3,_.toArray(c,m),m+=3}let u=new ii;u.setAttribute("position",new Ht(l,3)),u.setAttribute("color",new Ht(c,3));let d=new ka({vertexColors:!0,toneMapped:!1});super(u,d),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var il=class extends ki{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function If(n,e,t,i){let s=dM(i);switch(t){case gf:return n*e;case xf:return n*e/s.components*s.byteLength;case ph:return n*e/s.components*s.byteLength;case sr:return n*e*2/s.components*s.byteLength;case mh:return n*e*2/s.components*s.byteLength;case _f:return n*e*3/s.components*s.byteLength;case qi:return n*e*4/s.components*s.byteLength;case gh:return n*e*4/s.components*s.byteLength;case ol:case al:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case ll:case cl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case xh:case vh:return Math.max(n,16)*Math.max(e,8)/4;case _h:case yh:return Math.max(n,8)*Math.max(e,8)/2;case Sh:case Mh:case wh:case Eh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case bh:case hl:case Th:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Ah:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Rh:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Ch:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case Ph:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Ih:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Lh:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Dh:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Nh:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Uh:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Fh:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Oh:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Bh:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case kh:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case zh:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Vh:case Gh:case Hh:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Wh:case qh:return Math.ceil(n/4)*Math.ceil(e/4)*8;case ul:case Xh:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function dM(n){switch(n){case si:case df:return{byteLength:1,components:1};case Yo:case ff:case Wi:return{byteLength:2,components:1};case dh:case fh:return{byteLength:2,components:4};case Gi:case uh:case Hi:return{byteLength:4,components:1};case pf:case mf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?je("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function A_(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function pM(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,d=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,u),a.onUploadCallback();let m;if(c instanceof Float32Array)m=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)m=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?m=n.HALF_FLOAT:m=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)m=n.SHORT;else if(c instanceof Uint32Array)m=n.UNSIGNED_INT;else if(c instanceof Int32Array)m=n.INT;else if(c instanceof Int8Array)m=n.BYTE;else if(c instanceof Uint8Array)m=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)m=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:m,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function i(a,l,c){let u=l.array,d=l.updateRanges;if(n.bindBuffer(c,a),d.length===0)n.bufferSubData(c,0,u);else{d.sort((m,g)=>m.start-g.start);let h=0;for(let m=1;m<d.length;m++){let g=d[h],_=d[m];_.start<=g.start+g.count+1?g.count=Math.max(g.count,_.start+_.count-g.start):(++h,d[h]=_)}d.length=h+1;for(let m=0,g=d.length;m<g;m++){let _=d[m];n.bufferSubData(c,_.start*u.BYTES_PER_ELEMENT,u,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var mM=`#ifdef USE_ALPHAHASH
if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,gM=`#ifdef USE_ALPHAHASH
const float ALPHA_HASH_SCALE = 0.05;
float hash2D( vec2 value ) {
return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
}
float hash3D( vec3 value ) {
return hash2D( vec2( hash2D( value.xy ), value.z ) );
}
float getAlphaHashThreshold( vec3 position ) {
float maxDeriv = max(
length( dFdx( position.xyz ) ),
length( dFdy( position.xyz ) )
);
float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
vec2 pixScales = vec2(
exp2( floor( log2( pixScale ) ) ),
exp2( ceil( log2( pixScale ) ) )
);
vec2 alpha = vec2(
hash3D( floor( pixScales.x * position.xyz ) ),
hash3D( floor( pixScales.y * position.xyz ) )
);
float lerpFactor = fract( log2( pixScale ) );
float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
float a = min( lerpFactor, 1.0 - lerpFactor );
vec3 cases = vec3(
x * x / ( 2.0 * a * ( 1.0 - a ) ),
( x - 0.5 * a ) / ( 1.0 - a ),
1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
);
float threshold = ( x < ( 1.0 - a ) )
? ( ( x < a ) ? cases.x : cases.y )
: cases.z;
return clamp( threshold , 1.0e-6, 1.0 );
}
#endif`,_M=`#ifdef USE_ALPHAMAP
diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,xM=`#ifdef USE_ALPHAMAP
uniform sampler2D alphaMap;
#endif`,yM=`#ifdef USE_ALPHATEST
#ifdef ALPHA_TO_COVERAGE
diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
if ( diffuseColor.a == 0.0 ) discard;
#else
if ( diffuseColor.a < alphaTest ) discard;
#endif
#endif`,vM=`#ifdef USE_ALPHATEST
uniform float alphaTest;
#endif`,SM=`#ifdef USE_AOMAP
float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
reflectedLight.indirectDiffuse *= ambientOcclusion;
#if defined( USE_CLEARCOAT ) 
clearcoatSpecularIndirect *= ambientOcclusion;
#endif
#if defined( USE_SHEEN ) 
sheenSpecularIndirect *= ambientOcclusion;
#endif
#if defined( USE_ENVMAP ) && defined( STANDARD )
float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
#endif
#endif`,MM=`#ifdef USE_AOMAP
uniform sampler2D aoMap;
uniform float aoMapIntensity;
#endif`,bM=`#ifdef USE_BATCHING
#if ! defined( GL_ANGLE_multi_draw )
#define gl_DrawID _gl_DrawID
uniform int _gl_DrawID;
#endif
uniform highp sampler2D batchingTexture;
uniform highp usampler2D batchingIdTexture;
mat4 getBatchingMatrix( const in float i ) {
int size = textureSize( batchingTexture, 0 ).x;
int j = int( i ) * 4;
int x = j % size;
int y = j / size;
vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
return mat4( v1, v2, v3, v4 );
}
float getIndirectIndex( const in int i ) {
int size = textureSize( batchingIdTexture, 0 ).x;
int x = i % size;
int y = i / size;
return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
}
#endif
#ifdef USE_BATCHING_COLOR
uniform sampler2D batchingColorTexture;
vec4 getBatchingColor( const in float i ) {
int size = textureSize( batchingColorTexture, 0 ).x;
int j = int( i );
int x = j % size;
int y = j / size;
return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
}
#endif`,wM=`#ifdef USE_BATCHING
mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,EM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
vPosition = vec3( position );
#endif`,TM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
vec3 objectTangent = vec3( tangent.xyz );
#endif`,AM=`float G_BlinnPhong_Implicit( ) {
return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
vec3 halfDir = normalize( lightDir + viewDir );
float dotNH = saturate( dot( normal, halfDir ) );
float dotVH = saturate( dot( viewDir, halfDir ) );
vec3 F = F_Schlick( specularColor, 1.0, dotVH );
float G = G_BlinnPhong_Implicit( );
float D = D_BlinnPhong( shininess, dotNH );
return F * ( G * D );
} // validated`,RM=`#ifdef USE_IRIDESCENCE
const mat3 XYZ_TO_REC709 = mat3(
 3.2404542, -0.9692660,  0.0556434,
-1.5371385,  1.8760108, -0.2040259,
-0.4985314,  0.0415560,  1.0572252
);
vec3 Fresnel0ToIor( vec3 fresnel0 ) {
vec3 sqrtF0 = sqrt( fresnel0 );
return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
}
vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
}
float IorToFresnel0( float transmittedIor, float incidentIor ) {
return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
}
vec3 evalSensitivity( float OPD, vec3 shift ) {
float phase = 2.0 * PI * OPD * 1.0e-9;
vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
xyz /= 1.0685e-7;
vec3 rgb = XYZ_TO_REC709 * xyz;
return rgb;
}
vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
vec3 I;
float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
float cosTheta2Sq = 1.0 - sinTheta2Sq;
if ( cosTheta2Sq < 0.0 ) {
return vec3( 1.0 );
}
float cosTheta2 = sqrt( cosTheta2Sq );
float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
float R12 = F_Schlick( R0, 1.0, cosTheta1 );
float T121 = 1.0 - R12;
float phi12 = 0.0;
if ( iridescenceIOR < outsideIOR ) phi12 = PI;
float phi21 = PI - phi12;
vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
vec3 phi23 = vec3( 0.0 );
if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
vec3 phi = vec3( phi21 ) + phi23;
vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
vec3 r123 = sqrt( R123 );
vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
vec3 C0 = R12 + Rs;
I = C0;
vec3 Cm = Rs - T121;
for ( int m = 1; m <= 2; ++ m ) {
Cm *= r123;
vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
I += Cm * Sm;
}
return max( I, vec3( 0.0 ) );
}
#endif`,CM=`#ifdef USE_BUMPMAP
uniform sampler2D bumpMap;
uniform float bumpScale;
vec2 dHdxy_fwd() {
vec2 dSTdx = dFdx( vBumpMapUv );
vec2 dSTdy = dFdy( vBumpMapUv );
float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
return vec2( dBx, dBy );
}
vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
vec3 vN = surf_norm;
vec3 R1 = cross( vSigmaY, vN );
vec3 R2 = cross( vN, vSigmaX );
float fDet = dot( vSigmaX, R1 ) * faceDirection;
vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
return normalize( abs( fDet ) * surf_norm - vGrad );
}
#endif`,PM=`#if NUM_CLIPPING_PLANES > 0
vec4 plane;
#ifdef ALPHA_TO_COVERAGE
float distanceToPlane, distanceGradient;
float clipOpacity = 1.0;
#pragma unroll_loop_start
for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
plane = clippingPlanes[ i ];
distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
distanceGradient = fwidth( distanceToPlane ) / 2.0;
clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
if ( clipOpacity == 0.0 ) discard;
}
#pragma unroll_loop_end
#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
float unionClipOpacity = 1.0;
#pragma unroll_loop_start
for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
plane = clippingPlanes[ i ];
distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
distanceGradient = fwidth( distanceToPlane ) / 2.0;
unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
}
#pragma unroll_loop_end
clipOpacity *= 1.0 - unionClipOpacity;
#endif
diffuseColor.a *= clipOpacity;
if ( diffuseColor.a == 0.0 ) discard;
#else
#pragma unroll_loop_start
for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
plane = clippingPlanes[ i ];
if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
}
#pragma unroll_loop_end
#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
bool clipped = true;
#pragma unroll_loop_start
for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
plane = clippingPlanes[ i ];
clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
}
#pragma unroll_loop_end
if ( clipped ) discard;
#endif
#endif
#endif`,IM=`#if NUM_CLIPPING_PLANES > 0
varying vec3 vClipPosition;
uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,LM=`#if NUM_CLIPPING_PLANES > 0
varying vec3 vClipPosition;
#endif`,DM=`#if NUM_CLIPPING_PLANES > 0
vClipPosition = - mvPosition.xyz;
#endif`,NM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
diffuseColor *= vColor;
#endif`,UM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
varying vec4 vColor;
#endif`,FM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
varying vec4 vColor;
#endif`,OM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
vColor *= color;
#elif defined( USE_COLOR )
vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,BM=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
const highp float a = 12.9898, b = 78.233, c = 43758.5453;
highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
float precisionSafeLength( vec3 v ) { return length( v ); }
#else
float precisionSafeLength( vec3 v ) {
float maxComponent = max3( abs( v ) );
return length( v / maxComponent ) * maxComponent;
}
#endif
struct IncidentLight {
vec3 color;
vec3 direction;
bool visible;
};
struct ReflectedLight {
vec3 directDiffuse;
vec3 directSpecular;
vec3 indirectDiffuse;
vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,kM=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
mat3 bm = mat3( batchingMatrix );
transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
transformedNormal = bm * transformedNormal;
#ifdef USE_TANGENT
transformedTangent = bm * transformedTangent;
#endif
#endif
#ifdef USE_INSTANCING
mat3 im = mat3( instanceMatrix );
transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
transformedNormal = im * transformedNormal;
#ifdef USE_TANGENT
transformedTangent = im * transformedTangent;
#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,zM=`#ifdef USE_DISPLACEMENTMAP
uniform sampler2D displacementMap;
uniform float displacementScale;
uniform float displacementBias;
#endif`,VM=`#ifdef USE_DISPLACEMENTMAP
transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,GM=`#ifdef USE_EMISSIVEMAP
vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
emissiveColor = sRGBTransferEOTF( emissiveColor );
#endif
totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,HM=`#ifdef USE_EMISSIVEMAP
uniform sampler2D emissiveMap;
#endif`,WM="gl_FragColor = linearToOutputTexel( gl_FragColor );",qM=`vec4 LinearTransferOETF( in vec4 value ) {
return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,XM=`#ifdef USE_ENVMAP
#ifdef ENV_WORLDPOS
vec3 cameraToFrag;
if ( isOrthographic ) {
cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
} else {
cameraToFrag = normalize( vWorldPosition - cameraPosition );
}
vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
#ifdef ENVMAP_MODE_REFLECTION
vec3 reflectVec = reflect( cameraToFrag, worldNormal );
#else
vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
#endif
#else
vec3 reflectVec = vReflect;
#endif
#ifdef ENVMAP_TYPE_CUBE
vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
#ifdef ENVMAP_BLENDING_MULTIPLY
outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
#elif defined( ENVMAP_BLENDING_MIX )
outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
#elif defined( ENVMAP_BLENDING_ADD )
outgoingLight += envColor.xyz * specularStrength * reflectivity;
#endif
#endif
#endif`,YM=`#ifdef USE_ENVMAP
uniform float envMapIntensity;
uniform mat3 envMapRotation;
uniform samplerCube envMap;
#ifdef ENVMAP_TYPE_PMREM
float roughnessToMip( const in float roughness ) {
float r = clamp( roughness, 0.0, 1.0 );
return ENVMAP_MAX_LOD * r * ( 2.0 - r );
}
#endif
#endif`,$M=`#ifdef USE_ENVMAP
uniform float reflectivity;
#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
#define ENV_WORLDPOS
#endif
#ifdef ENV_WORLDPOS
varying vec3 vWorldPosition;
uniform float refractionRatio;
#else
varying vec3 vReflect;
#endif
#endif`,ZM=`#ifdef USE_ENVMAP
#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
#define ENV_WORLDPOS
#endif
#ifdef ENV_WORLDPOS

varying vec3 vWorldPosition;
#else
varying vec3 vReflect;
uniform float refractionRatio;
#endif
#endif`,jM=`#ifdef USE_ENVMAP
#ifdef ENV_WORLDPOS
vWorldPosition = worldPosition.xyz;
#else
vec3 cameraToVertex;
if ( isOrthographic ) {
cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
} else {
cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
}
vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
#ifdef ENVMAP_MODE_REFLECTION
vReflect = reflect( cameraToVertex, worldNormal );
#else
vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
#endif
#endif
#endif`,JM=`#ifdef USE_FOG
vFogDepth = - mvPosition.z;
#endif`,KM=`#ifdef USE_FOG
varying float vFogDepth;
#endif`,QM=`#ifdef USE_FOG
#ifdef FOG_EXP2
float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
#else
float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
#endif
gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,eb=`#ifdef USE_FOG
uniform vec3 fogColor;
varying float vFogDepth;
#ifdef FOG_EXP2
uniform float fogDensity;
#else
uniform float fogNear;
uniform float fogFar;
#endif
#endif`,tb=`#ifdef USE_GRADIENTMAP
uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
float dotNL = dot( normal, lightDirection );
vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
#ifdef USE_GRADIENTMAP
return vec3( texture2D( gradientMap, coord ).r );
#else
vec2 fw = fwidth( coord ) * 0.5;
return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
#endif
}`,nb=`#ifdef USE_LIGHTMAP
uniform sampler2D lightMap;
uniform float lightMapIntensity;
#endif`,ib=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,sb=`varying vec3 vViewPosition;
struct LambertMaterial {
vec3 diffuseColor;
float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
vec3 irradiance = dotNL * directLight.color;
reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,rb=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
float x = normal.x, y = normal.y, z = normal.z;
vec3 result = shCoefficients[ 0 ] * 0.886227;
result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
vec3 irradiance = ambientLightColor;
return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
if ( cutoffDistance > 0.0 ) {
distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
}
return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
struct SunLight {
vec3 direction;
vec3 color;
};
uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
light.color = sunLight.color;
light.direction = sunLight.direction;
light.visible = true;
}
#endif
#if NUM_DIR_LIGHTS > 0
struct DirectionalLight {
vec3 direction;
vec3 color;
};
uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
light.color = directionalLight.color;
light.direction = directionalLight.direction;
light.visible = true;
}
#endif
#if NUM_POINT_LIGHTS > 0
struct PointLight {
vec3 position;
vec3 color;
float distance;
float decay;
};
uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
vec3 lVector = pointLight.position - geometryPosition;
light.direction = normalize( lVector );
float lightDistance = length( lVector );
light.color = pointLight.color;
light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
light.visible = ( light.color != vec3( 0.0 ) );
}
#endif
#if NUM_SPOT_LIGHTS > 0
struct SpotLight {
vec3 position;
vec3 direction;
vec3 color;
float distance;
float decay;
float coneCos;
float penumbraCos;
};
uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
vec3 lVector = spotLight.position - geometryPosition;
light.direction = normalize( lVector );
float angleCos = dot( light.direction, spotLight.direction );
float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
if ( spotAttenuation > 0.0 ) {
float lightDistance = length( lVector );
light.color = spotLight.color * spotAttenuation;
light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
light.visible = ( light.color != vec3( 0.0 ) );
} else {
light.color = vec3( 0.0 );
light.visible = false;
}
}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
struct RectAreaLight {
vec3 color;
vec3 position;
vec3 halfWidth;
vec3 halfHeight;
};
uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
struct HemisphereLight {
vec3 direction;
vec3 skyColor;
vec3 groundColor;
};
uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
float dotNL = dot( normal, hemiLight.direction );
float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
return irradiance;
}
#endif
#include <lightprobes_pars_fragment>`,ob=`#ifdef USE_ENVMAP
vec3 getIBLIrradiance( const in vec3 normal ) {
#ifdef ENVMAP_TYPE_PMREM
vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
return PI * envMapColor.rgb * envMapIntensity;
#else
return vec3( 0.0 );
#endif
}
vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
#ifdef ENVMAP_TYPE_PMREM
vec3 reflectVec = reflect( - viewDir, normal );
reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
return envMapColor.rgb * envMapIntensity;
#else
return vec3( 0.0 );
#endif
}
#ifdef USE_RETROREFLECTION
vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
#ifdef ENVMAP_TYPE_PMREM
vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
return envMapColor.rgb * envMapIntensity;
#else
return vec3( 0.0 );
#endif
}
#endif
#ifdef USE_ANISOTROPY
vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
#ifdef ENVMAP_TYPE_PMREM
vec3 bentNormal = cross( bitangent, viewDir );
bentNormal = normalize( cross( bentNormal, bitangent ) );
bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
return getIBLRadiance( viewDir, bentNormal, roughness );
#else
return vec3( 0.0 );
#endif
}
#ifdef USE_RETROREFLECTION
vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
#ifdef ENVMAP_TYPE_PMREM
vec3 bentNormal = cross( bitangent, viewDir );
bentNormal = normalize( cross( bentNormal, bitangent ) );
bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
return getIBLRetroRadiance( viewDir, bentNormal, roughness );
#else
return vec3( 0.0 );
#endif
}
#endif
#endif
#endif`,ab=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,lb=`varying vec3 vViewPosition;
struct ToonMaterial {
vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,cb=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,hb=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
vec3 diffuseColor;
vec3 specularColor;
float specularShininess;
float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
vec3 irradiance = dotNL * directLight.color;
reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,ub=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
float diffuseRoughnessFactor = diffuseRoughness;
#ifdef USE_DIFFUSE_ROUGHNESSMAP
diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
#endif
material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
material.ior = ior;
#ifdef USE_SPECULAR
float specularIntensityFactor = specularIntensity;
vec3 specularColorFactor = specularColor;
#ifdef USE_SPECULAR_COLORMAP
specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
#endif
material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
#else
float specularIntensityFactor = 1.0;
vec3 specularColorFactor = vec3( 1.0 );
material.specularF90 = 1.0;
#endif
material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
material.specularColor = vec3( 0.04 );
material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
material.clearcoat = clearcoat;
material.clearcoatRoughness = clearcoatRoughness;
material.clearcoatF0 = vec3( 0.04 );
material.clearcoatF90 = 1.0;
#ifdef USE_CLEARCOATMAP
material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
#endif
material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
material.clearcoatRoughness += geometryRoughness;
material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
material.iridescence = iridescence;
material.iridescenceIOR = iridescenceIOR;
#ifdef USE_IRIDESCENCEMAP
material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
#else
material.iridescenceThickness = iridescenceThicknessMaximum;
#endif
#endif
#ifdef USE_SHEEN
material.sheenColor = sheenColor;
#ifdef USE_SHEEN_COLORMAP
material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
#endif
material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
#ifdef USE_SHEEN_ROUGHNESSMAP
material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
#endif
#endif
#ifdef USE_ANISOTROPY
#ifdef USE_ANISOTROPYMAP
mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
#else
vec2 anisotropyV = anisotropyVector;
#endif
material.anisotropy = length( anisotropyV );
if( material.anisotropy == 0.0 ) {
anisotropyV = vec2( 1.0, 0.0 );
} else {
anisotropyV /= material.anisotropy;
material.anisotropy = saturate( material.anisotropy );
}
material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,db=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
vec3 diffuseColor;
vec3 diffuseContribution;
vec3 specularColor;
vec3 specularColorBlended;
float roughness;
float metalness;
float specularF90;
float dispersion;
vec2 dfg;
vec3 multiScatteringCompensation;
#ifdef USE_DIFFUSE_ROUGHNESS
float diffuseRoughness;
#endif
#ifdef USE_RETROREFLECTION
float retroreflectivity;
#endif
#ifdef USE_CLEARCOAT
float clearcoat;
float clearcoatRoughness;
vec3 clearcoatF0;
float clearcoatF90;
#endif
#ifdef USE_IRIDESCENCE
float iridescence;
float iridescenceIOR;
float iridescenceThickness;
vec3 iridescenceFresnel;
vec3 iridescenceF0Dielectric;
vec3 iridescenceF0Metallic;
#endif
#ifdef USE_SHEEN
vec3 sheenColor;
float sheenRoughness;
#endif
#ifdef IOR
float ior;
#endif
#ifdef USE_TRANSMISSION
float transmission;
float transmissionAlpha;
float thickness;
float attenuationDistance;
vec3 attenuationColor;
#endif
#ifdef USE_ANISOTROPY
float anisotropy;
float alphaT;
vec3 anisotropyT;
vec3 anisotropyB;
#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
const float EON_EPSILON = 1e-7;
float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
float muComp = 1.0 - mu;
float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
return A * ( 1.0 + roughness * gOverPi );
}
vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
vec3 rho = saturate( diffuseColor );
if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
float dotNL = saturate( dot( normal, lightDir ) );
float dotNV = saturate( dot( normal, viewDir ) );
float s = dot( lightDir, viewDir ) - dotNL * dotNV;
float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
* max( EON_EPSILON, 1.0 - albedoV )
* max( EON_EPSILON, 1.0 - albedoL )
/ max( EON_EPSILON, 1.0 - averageAlbedo );
return singleScatter + multiScatter;
}
vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
vec3 rho = saturate( diffuseColor );
if ( roughness <= EON_EPSILON ) return rho;
float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
float a2 = pow2( alpha );
float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
float a2 = pow2( alpha );
float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
float a2 = alphaT * alphaB;
highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
highp float v2 = dot( v, v );
float w2 = a2 / v2;
return RECIPROCAL_PI * a2 * pow2 ( w2 );
}
#endif
#ifdef USE_CLEARCOAT
vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
vec3 f0 = material.clearcoatF0;
float f90 = material.clearcoatF90;
float roughness = max( material.clearcoatRoughness, 0.045 );
float alpha = pow2( roughness );
vec3 halfDir = normalize( lightDir + viewDir );
float dotNL = saturate( dot( normal, lightDir ) );
float dotNV = saturate( dot( normal, viewDir ) );
float dotNH = saturate( dot( normal, halfDir ) );
float dotVH = saturate( dot( viewDir, halfDir ) );
vec3 F = F_Schlick( f0, f90, dotVH );
float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
float D = D_GGX( alpha, dotNH );
return F * ( V * D );
}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
vec3 f0 = material.specularColorBlended;
float f90 = material.specularF90;
float roughness = max( material.roughness, 0.045 );
float alpha = pow2( roughness );
vec3 halfDir = normalize( lightDir + viewDir );
float dotNL = saturate( dot( normal, lightDir ) );
float dotNV = saturate( dot( normal, viewDir ) );
float dotNH = saturate( dot( normal, halfDir ) );
float dotVH = saturate( dot( viewDir, halfDir ) );
vec3 F = F_Schlick( f0, f90, dotVH );
#ifdef USE_IRIDESCENCE
F = mix( F, material.iridescenceFresnel, material.iridescence );
#endif
#ifdef USE_ANISOTROPY
float dotTL = dot( material.anisotropyT, lightDir );
float dotTV = dot( material.anisotropyT, viewDir );
float dotTH = dot( material.anisotropyT, halfDir );
float dotBL = dot( material.anisotropyB, lightDir );
float dotBV = dot( material.anisotropyB, viewDir );
float dotBH = dot( material.anisotropyB, halfDir );
float alphaT = max( material.alphaT, alpha );
float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
#else
float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
float D = D_GGX( alpha, dotNH );
#endif
return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
const float LUT_SIZE = 64.0;
const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
const float LUT_BIAS = 0.5 / LUT_SIZE;
float dotNV = saturate( dot( N, V ) );
vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
uv = uv * LUT_SCALE + LUT_BIAS;
return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
float l = length( f );
return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
float x = dot( v1, v2 );
float y = abs( x );
float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
float b = 3.4175940 + ( 4.1616724 + y ) * y;
float v = a / b;
float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
vec3 lightNormal = cross( v1, v2 );
if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
vec3 T1, T2;
T1 = normalize( V - N * dot( V, N ) );
T2 = - cross( N, T1 );
mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
vec3 coords[ 4 ];
coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
coords[ 0 ] = normalize( coords[ 0 ] );
coords[ 1 ] = normalize( coords[ 1 ] );
coords[ 2 ] = normalize( coords[ 2 ] );
coords[ 3 ] = normalize( coords[ 3 ] );
vec3 vectorFormFactor = vec3( 0.0 );
vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
float alpha = pow2( roughness );
float invAlpha = 1.0 / alpha;
float cos2h = dotNH * dotNH;
float sin2h = max( 1.0 - cos2h, 0.0078125 );
return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
vec3 halfDir = normalize( lightDir + viewDir );
float dotNL = saturate( dot( normal, lightDir ) );
float dotNV = saturate( dot( normal, viewDir ) );
float dotNH = saturate( dot( normal, halfDir ) );
float D = D_Charlie( sheenRoughness, dotNH );
float V = V_Neubelt( dotNV, dotNL );
return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
float dotNV = saturate( dot( normal, viewDir ) );
float r2 = roughness * roughness;
float rInv = 1.0 / ( roughness + 0.1 );
float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
float DG = exp( a * dotNV + b );
return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
float dotNV = saturate( dot( normal, viewDir ) );
vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
#ifdef USE_IRIDESCENCE
vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
#else
vec3 Fr = specularColor;
#endif
vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
float Ess = fab.x + fab.y;
float Ems = 1.0 - Ess;
vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
singleScatter += FssEss;
multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
vec3 normal = geometryNormal;
vec3 viewDir = geometryViewDir;
vec3 position = geometryPosition;
vec3 lightPos = rectAreaLight.position;
vec3 halfWidth = rectAreaLight.halfWidth;
vec3 halfHeight = rectAreaLight.halfHeight;
vec3 lightColor = rectAreaLight.color;
float roughness = material.roughness;
vec3 rectCoords[ 4 ];
rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
vec2 uv = LTC_Uv( normal, viewDir, roughness );
vec4 t1 = texture2D( ltc_1, uv );
vec4 t2 = texture2D( ltc_2, uv );
mat3 mInv = mat3(
vec3( t1.x, 0, t1.y ),
vec3(    0, 1,    0 ),
vec3( t1.z, 0, t1.w )
);
vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
#ifdef USE_CLEARCOAT
vec3 Ncc = geometryClearcoatNormal;
vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
mat3 mInvClearcoat = mat3(
vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
vec3(             0, 1,             0 ),
vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
);
vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
#endif
}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
vec3 irradiance = dotNL * directLight.color;
#ifdef USE_CLEARCOAT
float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
vec3 ccIrradiance = dotNLcc * directLight.color;
clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
#endif
#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
#ifdef USE_RETROREFLECTION
vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
#endif
reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
vec3 halfDir = normalize( directLight.direction + geometryViewDir );
float dotVH = saturate( dot( geometryViewDir, halfDir ) );
vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
#ifdef USE_RETROREFLECTION
vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
F = mix( F, retroF, saturate( material.retroreflectivity ) );
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
#else
vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
#endif
reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
vec3 singleScattering = vec3( 0.0 );
vec3 multiScattering = vec3( 0.0 );
#ifdef USE_IRIDESCENCE
computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
#else
computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
#else
vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
#endif
#ifdef USE_SHEEN
float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
diffuse *= sheenEnergyComp;
#endif
reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
#ifdef USE_CLEARCOAT
clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
#endif
#ifdef USE_SHEEN
sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
vec3 singleScatteringDielectric = vec3( 0.0 );
vec3 multiScatteringDielectric = vec3( 0.0 );
vec3 singleScatteringMetallic = vec3( 0.0 );
vec3 multiScatteringMetallic = vec3( 0.0 );
#ifdef USE_IRIDESCENCE
computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
#else
computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
#endif
vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
#ifdef USE_DIFFUSE_ROUGHNESS
float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
#else
vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
#endif
vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
vec3 indirectSpecular = radiance * singleScattering;
indirectSpecular += multiScattering * cosineWeightedIrradiance;
vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
#ifdef USE_SHEEN
float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
indirectSpecular *= sheenEnergyComp;
indirectDiffuse *= sheenEnergyComp;
#endif
reflectedLight.indirectSpecular += indirectSpecular;
reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,fb=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
float dotNVi = saturate( dot( normal, geometryViewDir ) );
if ( material.iridescenceThickness == 0.0 ) {
material.iridescence = 0.0;
} else {
material.iridescence = saturate( material.iridescence );
}
if ( material.iridescence > 0.0 ) {
vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
}
#endif
#ifdef STANDARD
float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
float EssMs = material.dfg.x + material.dfg.y;
material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
PointLight pointLight;
#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
PointLightShadow pointLightShadow;
#endif
#pragma unroll_loop_start
for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
pointLight = pointLights[ i ];
getPointLightInfo( pointLight, geometryPosition, directLight );
#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
pointLightShadow = pointLightShadows[ i ];
directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
#endif
RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
}
#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
SpotLight spotLight;
vec4 spotColor;
vec3 spotLightCoord;
bool inSpotLightMap;
#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
SpotLightShadow spotLightShadow;
#endif
#pragma unroll_loop_start
for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
spotLight = spotLights[ i ];
getSpotLightInfo( spotLight, geometryPosition, directLight );
#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
#else
#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
#endif
#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
#endif
#undef SPOT_LIGHT_MAP_INDEX
#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
spotLightShadow = spotLightShadows[ i ];
directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
#endif
RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
}
#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
SunLight sunLight;
#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
SunLightShadow sunLightShadow;
#endif
#pragma unroll_loop_start
for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
sunLight = sunLights[ i ];
getSunLightInfo( sunLight, directLight );
#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
sunLightShadow = sunLightShadows[ i ];
directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
#endif
RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
}
#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
DirectionalLight directionalLight;
#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
DirectionalLightShadow directionalLightShadow;
#endif
#pragma unroll_loop_start
for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
directionalLight = directionalLights[ i ];
getDirectionalLightInfo( directionalLight, directLight );
#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
directionalLightShadow = directionalLightShadows[ i ];
directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
#endif
RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
}
#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
RectAreaLight rectAreaLight;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
rectAreaLight = rectAreaLights[ i ];
RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
}
#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
vec3 iblIrradiance = vec3( 0.0 );
vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
#if defined( USE_LIGHT_PROBES )
irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
#endif
#if ( NUM_HEMI_LIGHTS > 0 )
#pragma unroll_loop_start
for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
}
#pragma unroll_loop_end
#endif
#if NUM_LIGHT_PROBE_GRIDS > 0
vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
int probeGrid = - 1;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
}
#pragma unroll_loop_end
#pragma unroll_loop_start
for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
}
#pragma unroll_loop_end
#endif
#endif
#if defined( RE_IndirectSpecular )
vec3 radiance = vec3( 0.0 );
vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,pb=`#if defined( RE_IndirectDiffuse )
#ifdef USE_LIGHTMAP
vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
irradiance += lightMapIrradiance;
#endif
#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
iblIrradiance += getIBLIrradiance( geometryNormal );
#endif
#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
#ifdef USE_ANISOTROPY
vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
#else
vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
#endif
#ifdef USE_RETROREFLECTION
#ifdef USE_ANISOTROPY
vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
#else
vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
#endif
iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
#endif
radiance += iblRadiance;
#ifdef USE_CLEARCOAT
clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
#endif
#endif`,mb=`#if defined( RE_IndirectDiffuse )
#if defined( LAMBERT ) || defined( PHONG )
irradiance += iblIrradiance;
#endif
RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,gb=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
vec3 spacing = ( probesMax - probesMin ) / probesResolution;
vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
vec3 margin = spacing * 0.01;
return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
vec3 res = probesResolution;
vec3 gridRange = probesMax - probesMin;
vec3 probeSpacing = gridRange / res;
vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
float nz          = res.z;
float paddedSlices = nz + 2.0;
float atlasDepth  = 7.0 * paddedSlices;
float uvZBase     = uvw.z * nz + 1.0;
vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
vec3 c0 = s0.xyz;
vec3 c1 = vec3( s0.w, s1.xy );
vec3 c2 = vec3( s1.zw, s2.x );
vec3 c3 = s2.yzw;
vec3 c4 = s3.xyz;
vec3 c5 = vec3( s3.w, s4.xy );
vec3 c6 = vec3( s4.zw, s5.x );
vec3 c7 = s5.yzw;
vec3 c8 = s6.xyz;
float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
vec3 result = c0 * 0.886227;
result += c1 * 2.0 * 0.511664 * y;
result += c2 * 2.0 * 0.511664 * z;
result += c3 * 2.0 * 0.511664 * x;
result += c4 * 2.0 * 0.429043 * x * y;
result += c5 * 2.0 * 0.429043 * y * z;
result += c6 * ( 0.743125 * z * z - 0.247708 );
result += c7 * 2.0 * 0.429043 * x * z;
result += c8 * 0.429043 * ( x * x - y * y );
return max( result, vec3( 0.0 ) );
}
#endif`,_b=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,xb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
uniform float logDepthBufFC;
varying float vFragDepth;
varying float vIsPerspective;
#endif`,yb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
varying float vFragDepth;
varying float vIsPerspective;
#endif`,vb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
vFragDepth = 1.0 + gl_Position.w;
vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Sb=`#ifdef USE_MAP
vec4 sampledDiffuseColor = texture2D( map, vMapUv );
#ifdef DECODE_VIDEO_TEXTURE
sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
#endif
diffuseColor *= sampledDiffuseColor;
#endif`,Mb=`#ifdef USE_MAP
uniform sampler2D map;
#endif`,bb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
#if defined( USE_POINTS_UV )
vec2 uv = vUv;
#else
vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
#endif
#endif
#ifdef USE_MAP
diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,wb=`#if defined( USE_POINTS_UV )
varying vec2 vUv;
#else
#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
uniform mat3 uvTransform;
#endif
#endif
#ifdef USE_MAP
uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
uniform sampler2D alphaMap;
#endif`,Eb=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
metalnessFactor *= texelMetalness.b;
#endif`,Tb=`#ifdef USE_METALNESSMAP
uniform sampler2D metalnessMap;
#endif`,Ab=`#ifdef USE_INSTANCING_MORPH
float morphTargetInfluences[ MORPHTARGETS_COUNT ];
float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
}
#endif`,Rb=`#if defined( USE_MORPHCOLORS )
#if defined( USE_COLOR_ALPHA )
vColor *= morphTargetBaseInfluence;
#elif defined( USE_COLOR )
vColor.rgb *= morphTargetBaseInfluence;
#endif
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
#if defined( USE_COLOR_ALPHA )
if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
#elif defined( USE_COLOR )
if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
#endif
}
#endif`,Cb=`#ifdef USE_MORPHNORMALS
objectNormal *= morphTargetBaseInfluence;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
}
#endif`,Pb=`#ifdef USE_MORPHTARGETS
#ifndef USE_INSTANCING_MORPH
uniform float morphTargetBaseInfluence;
uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
#endif
uniform sampler2DArray morphTargetsTexture;
uniform ivec2 morphTargetsTextureSize;
vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
int y = texelIndex / morphTargetsTextureSize.x;
int x = texelIndex - y * morphTargetsTextureSize.x;
ivec3 morphUV = ivec3( x, y, morphTargetIndex );
return texelFetch( morphTargetsTexture, morphUV, 0 );
}
#endif`,Ib=`#ifdef USE_MORPHTARGETS
transformed *= morphTargetBaseInfluence;
for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
}
#endif`,Lb=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
vec3 fdx = dFdx( vViewPosition );
vec3 fdy = dFdy( vViewPosition );
vec3 normal = normalize( cross( fdx, fdy ) );
#else
vec3 normal = normalize( vNormal );
#ifdef DOUBLE_SIDED
normal *= faceDirection;
#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
#ifdef USE_TANGENT
mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
#else
mat3 tbn = getTangentFrame( - vViewPosition, normal,
#if defined( USE_NORMALMAP )
vNormalMapUv
#elif defined( USE_CLEARCOAT_NORMALMAP )
vClearcoatNormalMapUv
#else
vUv
#endif
);
#endif
#ifdef DOUBLE_SIDED
tbn[0] *= faceDirection;
tbn[1] *= faceDirection;
#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
#ifdef USE_TANGENT
mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
#else
mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
#endif
#ifdef DOUBLE_SIDED
tbn2[0] *= faceDirection;
tbn2[1] *= faceDirection;
#endif
#endif
vec3 nonPerturbedNormal = normal;`,Db=`#ifdef USE_NORMALMAP_OBJECTSPACE
normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
#ifdef FLIP_SIDED
normal = - normal;
#endif
#ifdef DOUBLE_SIDED
normal = normal * faceDirection;
#endif
normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
#if defined( USE_PACKED_NORMALMAP )
mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
#endif
mapN.xy *= normalScale;
normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,Nb=`#ifndef FLAT_SHADED
varying vec3 vNormal;
#ifdef USE_TANGENT
varying vec3 vTangent;
varying vec3 vBitangent;
#endif
#endif`,Ub=`#ifndef FLAT_SHADED
varying vec3 vNormal;
#ifdef USE_TANGENT
varying vec3 vTangent;
varying vec3 vBitangent;
#endif
#endif`,Fb=`#ifndef FLAT_SHADED
vNormal = normalize( transformedNormal );
#ifdef USE_TANGENT
vTangent = normalize( transformedTangent );
vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
#ifdef FLIP_SIDED
vBitangent = - vBitangent;
#endif
#endif
#endif`,Ob=`#ifdef USE_NORMALMAP
uniform sampler2D normalMap;
uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
vec3 q0 = dFdx( eye_pos.xyz );
vec3 q1 = dFdy( eye_pos.xyz );
vec2 st0 = dFdx( uv.st );
vec2 st1 = dFdy( uv.st );
vec3 N = surf_norm;
vec3 q1perp = cross( q1, N );
vec3 q0perp = cross( N, q0 );
vec3 T = q1perp * st0.x + q0perp * st1.x;
vec3 B = q1perp * st0.y + q0perp * st1.y;
float det = max( dot( T, T ), dot( B, B ) );
float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
return mat3( T * scale, B * scale, N );
}
#endif`,Bb=`#ifdef USE_CLEARCOAT
vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,kb=`#ifdef USE_CLEARCOAT_NORMALMAP
vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
clearcoatMapN.xy *= clearcoatNormalScale;
clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,zb=`#ifdef USE_CLEARCOATMAP
uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
uniform sampler2D clearcoatNormalMap;
uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
uniform sampler2D clearcoatRoughnessMap;
#endif`,Vb=`#ifdef USE_IRIDESCENCEMAP
uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
uniform sampler2D iridescenceThicknessMap;
#endif`,Gb=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Hb=`vec3 packNormalToRGB( const in vec3 normal ) {
return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
if( v <= 0.0 )
return vec4( 0., 0., 0., 0. );
if( v >= 1.0 )
return vec4( 1., 1., 1., 1. );
float vuf;
float af = modf( v * PackFactors.a, vuf );
float bf = modf( vuf * ShiftRight8, vuf );
float gf = modf( vuf * ShiftRight8, vuf );
return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
if( v <= 0.0 )
return vec3( 0., 0., 0. );
if( v >= 1.0 )
return vec3( 1., 1., 1. );
float vuf;
float bf = modf( v * PackFactors.b, vuf );
float gf = modf( vuf * ShiftRight8, vuf );
return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
if( v <= 0.0 )
return vec2( 0., 0. );
if( v >= 1.0 )
return vec2( 1., 1. );
float vuf;
float gf = modf( v * 256., vuf );
return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
#ifdef USE_REVERSED_DEPTH_BUFFER

return depth * ( far - near ) - far;
#else
return depth * ( near - far ) - near;
#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {

#ifdef USE_REVERSED_DEPTH_BUFFER
return ( near * far ) / ( ( near - far ) * depth - near );
#else
return ( near * far ) / ( ( far - near ) * depth - far );
#endif
}`,Wb=`#ifdef PREMULTIPLIED_ALPHA
gl_FragColor.rgb *= gl_FragColor.a;
#endif`,qb=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Xb=`#ifdef DITHERING
gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Yb=`#ifdef DITHERING
vec3 dithering( vec3 color ) {
float grid_position = rand( gl_FragCoord.xy );
vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
return color + dither_shift_RGB;
}
#endif`,$b=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
roughnessFactor *= texelRoughness.g;
#endif`,Zb=`#ifdef USE_ROUGHNESSMAP
uniform sampler2D roughnessMap;
#endif`,jb=`#if NUM_SPOT_LIGHT_COORDS > 0
varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
#if NUM_SUN_LIGHT_SHADOWS > 0
#define SUN_LIGHT_CASCADES 2
#if defined( SHADOWMAP_TYPE_PCF )
uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
#else
uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
#endif
uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
varying vec4 vSunShadowWorldPosition;
varying vec3 vSunShadowWorldNormal;
struct SunLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
};
uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
#endif
#if NUM_DIR_LIGHT_SHADOWS > 0
#if defined( SHADOWMAP_TYPE_PCF )
uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
#else
uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
#endif
varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
struct DirectionalLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
};
uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
#endif
#if NUM_SPOT_LIGHT_SHADOWS > 0
#if defined( SHADOWMAP_TYPE_PCF )
uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
#else
uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
#endif
struct SpotLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
};
uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0
#if defined( SHADOWMAP_TYPE_PCF )
uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
#elif defined( SHADOWMAP_TYPE_BASIC )
uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
#endif
varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
struct PointLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
float shadowCameraNear;
float shadowCameraFar;
};
uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
#endif
#if defined( SHADOWMAP_TYPE_PCF )
float interleavedGradientNoise( vec2 position ) {
return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
}
vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
const float goldenAngle = 2.399963229728653;
float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
float theta = float( sampleIndex ) * goldenAngle + phi;
return vec2( cos( theta ), sin( theta ) ) * r;
}
#endif
#if defined( SHADOWMAP_TYPE_PCF )
float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
float shadow = 1.0;
shadowCoord.xyz /= shadowCoord.w;
#ifdef USE_REVERSED_DEPTH_BUFFER
shadowCoord.z -= shadowBias;
#else
shadowCoord.z += shadowBias;
#endif
bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
if ( frustumTest ) {
vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
vec2 radius = shadowRadius * texelSize;
float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
shadow = (
texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
) * 0.2;
}
return mix( 1.0, shadow, shadowIntensity );
}
#elif defined( SHADOWMAP_TYPE_VSM )
float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
float shadow = 1.0;
shadowCoord.xyz /= shadowCoord.w;
#ifdef USE_REVERSED_DEPTH_BUFFER
shadowCoord.z -= shadowBias;
#else
shadowCoord.z += shadowBias;
#endif
bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
if ( frustumTest ) {
vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
float mean = distribution.x;
float variance = distribution.y * distribution.y;
#ifdef USE_REVERSED_DEPTH_BUFFER
float hard_shadow = step( mean, shadowCoord.z );
#else
float hard_shadow = step( shadowCoord.z, mean );
#endif

if ( hard_shadow == 1.0 ) {
shadow = 1.0;
} else {
variance = max( variance, 0.0000001 );
float d = shadowCoord.z - mean;
float p_max = variance / ( variance + d * d );
p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
shadow = max( hard_shadow, p_max );
}
}
return mix( 1.0, shadow, shadowIntensity );
}
#else
float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
float shadow = 1.0;
shadowCoord.xyz /= shadowCoord.w;
#ifdef USE_REVERSED_DEPTH_BUFFER
shadowCoord.z -= shadowBias;
#else
shadowCoord.z += shadowBias;
#endif
bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
if ( frustumTest ) {
float depth = texture2D( shadowMap, shadowCoord.xy ).r;
#ifdef USE_REVERSED_DEPTH_BUFFER
shadow = step( depth, shadowCoord.z );
#else
shadow = step( shadowCoord.z, depth );
#endif
}
return mix( 1.0, shadow, shadowIntensity );
}
#endif
#if NUM_SUN_LIGHT_SHADOWS > 0
float getSunShadow(
#if defined( SHADOWMAP_TYPE_PCF )
sampler2DShadow shadowMap,
#else
sampler2D shadowMap,
#endif
SunLightShadow sunLightShadow,
int shadowIndex
) {
vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
float viewDepth = vSunShadowWorldPosition.w;
int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
float shadow = 1.0;
for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
float cascadeShadow = getShadow(
shadowMap,
sunLightShadow.shadowMapSize,
sunLightShadow.shadowIntensity,
sunLightShadow.shadowBias,
sunLightShadow.shadowRadius,
sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
);
shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
}
}
return shadow;
}
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0
#if defined( SHADOWMAP_TYPE_PCF )
float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
float shadow = 1.0;
vec3 lightToPosition = shadowCoord.xyz;
vec3 bd3D = normalize( lightToPosition );
vec3 absVec = abs( lightToPosition );
float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
float lightDistance = length( lightToPosition );
float depthRange = shadowCameraFar - shadowCameraNear;
#ifdef USE_REVERSED_DEPTH_BUFFER
float depthA = - shadowCameraNear / depthRange - shadowBias;
float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
#else
float depthA = shadowCameraFar / depthRange + shadowBias;
float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
#endif
float texelSize = shadowRadius / shadowMapSize.x;
vec3 absDir = abs( bd3D );
vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
tangent = normalize( cross( bd3D, tangent ) );
vec3 bitangent = cross( bd3D, tangent );
float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
shadow = 0.0;
for ( int i = 0; i < 5; i ++ ) {
vec2 offset = vogelDiskSample( i, 5, phi );
vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
vec3 absDirection = abs( direction );
float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
shadow += texture( shadowMap, vec4( direction, dp ) );
}
shadow *= 0.2;
}
return mix( 1.0, shadow, shadowIntensity );
}
#elif defined( SHADOWMAP_TYPE_BASIC )
float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
float shadow = 1.0;
vec3 lightToPosition = shadowCoord.xyz;
vec3 absVec = abs( lightToPosition );
float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
dp += shadowBias;
vec3 bd3D = normalize( lightToPosition );
float depth = textureCube( shadowMap, bd3D ).r;
#ifdef USE_REVERSED_DEPTH_BUFFER
depth = 1.0 - depth;
#endif
shadow = step( dp, depth );
}
return mix( 1.0, shadow, shadowIntensity );
}
#endif
#endif
#endif`,Jb=`#if NUM_SPOT_LIGHT_COORDS > 0
uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
#if NUM_SUN_LIGHT_SHADOWS > 0
varying vec4 vSunShadowWorldPosition;
varying vec3 vSunShadowWorldNormal;
#endif
#if NUM_DIR_LIGHT_SHADOWS > 0
uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
struct DirectionalLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
};
uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
#endif
#if NUM_SPOT_LIGHT_SHADOWS > 0
struct SpotLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
};
uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0
uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
struct PointLightShadow {
float shadowIntensity;
float shadowBias;
float shadowNormalBias;
float shadowRadius;
vec2 shadowMapSize;
float shadowCameraNear;
float shadowCameraFar;
};
uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
#endif
#endif`,Kb=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
#ifdef HAS_NORMAL
vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
#else
vec3 shadowWorldNormal = vec3( 0.0 );
#endif
vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
#if NUM_SUN_LIGHT_SHADOWS > 0
vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
vSunShadowWorldNormal = shadowWorldNormal;
#endif
#if NUM_DIR_LIGHT_SHADOWS > 0
#pragma unroll_loop_start
for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
}
#pragma unroll_loop_end
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0
#pragma unroll_loop_start
for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
}
#pragma unroll_loop_end
#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
#pragma unroll_loop_start
for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
shadowWorldPosition = worldPosition;
#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
#endif
vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
}
#pragma unroll_loop_end
#endif`,Qb=`float getShadowMask() {
float shadow = 1.0;
#ifdef USE_SHADOWMAP
#if NUM_SUN_LIGHT_SHADOWS > 0
SunLightShadow sunLight;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
sunLight = sunLightShadows[ i ];
shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
}
#pragma unroll_loop_end
#endif
#if NUM_DIR_LIGHT_SHADOWS > 0
DirectionalLightShadow directionalLight;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
directionalLight = directionalLightShadows[ i ];
shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
}
#pragma unroll_loop_end
#endif
#if NUM_SPOT_LIGHT_SHADOWS > 0
SpotLightShadow spotLight;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
spotLight = spotLightShadows[ i ];
shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
}
#pragma unroll_loop_end
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
PointLightShadow pointLight;
#pragma unroll_loop_start
for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
pointLight = pointLightShadows[ i ];
shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
}
#pragma unroll_loop_end
#endif
#endif
return shadow;
}`,e1=`#ifdef USE_SKINNING
mat4 boneMatX = getBoneMatrix( skinIndex.x );
mat4 boneMatY = getBoneMatrix( skinIndex.y );
mat4 boneMatZ = getBoneMatrix( skinIndex.z );
mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,t1=`#ifdef USE_SKINNING
uniform mat4 bindMatrix;
uniform mat4 bindMatrixInverse;
uniform highp sampler2D boneTexture;
mat4 getBoneMatrix( const in float i ) {
int size = textureSize( boneTexture, 0 ).x;
int j = int( i ) * 4;
int x = j % size;
int y = j / size;
vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
return mat4( v1, v2, v3, v4 );
}
#endif`,n1=`#ifdef USE_SKINNING
vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
vec4 skinned = vec4( 0.0 );
skinned += boneMatX * skinVertex * skinWeight.x;
skinned += boneMatY * skinVertex * skinWeight.y;
skinned += boneMatZ * skinVertex * skinWeight.z;
skinned += boneMatW * skinVertex * skinWeight.w;
transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,i1=`#ifdef USE_SKINNING
mat4 skinMatrix = mat4( 0.0 );
skinMatrix += skinWeight.x * boneMatX;
skinMatrix += skinWeight.y * boneMatY;
skinMatrix += skinWeight.z * boneMatZ;
skinMatrix += skinWeight.w * boneMatW;
skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
#ifdef USE_TANGENT
objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
#endif
#endif`,s1=`float specularStrength;
#ifdef USE_SPECULARMAP
vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
specularStrength = texelSpecular.r;
#else
specularStrength = 1.0;
#endif`,r1=`#ifdef USE_SPECULARMAP
uniform sampler2D specularMap;
#endif`,o1=`#if defined( TONE_MAPPING )
gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,a1=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
color *= toneMappingExposure;
return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
color *= toneMappingExposure;
color = max( vec3( 0.0 ), color - 0.004 );
return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
const mat3 ACESInputMat = mat3(
vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
vec3( 0.04823, 0.01566, 0.83777 )
);
const mat3 ACESOutputMat = mat3(
vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
vec3( -0.07367, -0.00605,  1.07602 )
);
color *= toneMappingExposure / 0.6;
color = ACESInputMat * color;
color = RRTAndODTFit( color );
color = ACESOutputMat * color;
return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
vec3( 1.6605, - 0.1246, - 0.0182 ),
vec3( - 0.5876, 1.1329, - 0.1006 ),
vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
vec3( 0.6274, 0.0691, 0.0164 ),
vec3( 0.3293, 0.9195, 0.0880 ),
vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
vec3 x2 = x * x;
vec3 x4 = x2 * x2;
return + 15.5 * x4 * x2
- 40.14 * x4 * x
+ 31.96 * x4
- 6.868 * x2 * x
+ 0.4298 * x2
+ 0.1191 * x
- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
const mat3 AgXInsetMatrix = mat3(
vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
);
const mat3 AgXOutsetMatrix = mat3(
vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
);
const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
color *= toneMappingExposure;
color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
color = AgXInsetMatrix * color;
color = max( color, 1e-10 );	color = log2( color );
color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
color = clamp( color, 0.0, 1.0 );
color = agxDefaultContrastApprox( color );
color = AgXOutsetMatrix * color;
color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
color = clamp( color, 0.0, 1.0 );
return color;
}
vec3 NeutralToneMapping( vec3 color ) {
const float StartCompression = 0.8 - 0.04;
const float Desaturation = 0.15;
color *= toneMappingExposure;
float x = min( color.r, min( color.g, color.b ) );
float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
color -= offset;
float peak = max( color.r, max( color.g, color.b ) );
if ( peak < StartCompression ) return color;
float d = 1. - StartCompression;
float newPeak = 1. - d * d / ( peak + d - StartCompression );
color *= newPeak / peak;
float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,l1=`#ifdef USE_TRANSMISSION
material.transmission = transmission;
material.transmissionAlpha = 1.0;
material.thickness = thickness;
material.attenuationDistance = attenuationDistance;
material.attenuationColor = attenuationColor;
#ifdef USE_TRANSMISSIONMAP
material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
#endif
#ifdef USE_THICKNESSMAP
material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
#endif
vec3 pos = vWorldPosition;
vec3 v = normalize( cameraPosition - pos );
vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
vec4 transmitted = getIBLVolumeRefraction(
n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
material.attenuationColor, material.attenuationDistance );
material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,c1=`#ifdef USE_TRANSMISSION
uniform float transmission;
uniform float thickness;
uniform float attenuationDistance;
uniform vec3 attenuationColor;
#ifdef USE_TRANSMISSIONMAP
uniform sampler2D transmissionMap;
#endif
#ifdef USE_THICKNESSMAP
uniform sampler2D thicknessMap;
#endif
uniform vec2 transmissionSamplerSize;
uniform sampler2D transmissionSamplerMap;
uniform mat4 modelMatrix;
uniform mat4 projectionMatrix;
varying vec3 vWorldPosition;
float w0( float a ) {
return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
}
float w1( float a ) {
return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
}
float w2( float a ){
return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
}
float w3( float a ) {
return ( 1.0 / 6.0 ) * ( a * a * a );
}
float g0( float a ) {
return w0( a ) + w1( a );
}
float g1( float a ) {
return w2( a ) + w3( a );
}
float h0( float a ) {
return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
}
float h1( float a ) {
return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
}
vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
uv = uv * texelSize.zw + 0.5;
vec2 iuv = floor( uv );
vec2 fuv = fract( uv );
float g0x = g0( fuv.x );
float g1x = g1( fuv.x );
float h0x = h0( fuv.x );
float h1x = h1( fuv.x );
float h0y = h0( fuv.y );
float h1y = h1( fuv.y );
vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
}
vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
vec2 fLodSizeInv = 1.0 / fLodSize;
vec2 cLodSizeInv = 1.0 / cLodSize;
vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
return mix( fSample, cSample, fract( lod ) );
}
vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
vec3 modelScale;
modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
return normalize( refractionVector ) * thickness * modelScale;
}
float applyIorToRoughness( const in float roughness, const in float ior ) {
return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
}
vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
}
vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
if ( isinf( attenuationDistance ) ) {
return vec3( 1.0 );
} else {
vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
}
}
vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
const in vec3 attenuationColor, const in float attenuationDistance ) {
vec4 transmittedLight;
vec3 transmittance;
#ifdef USE_DISPERSION
float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
for ( int i = 0; i < 3; i ++ ) {
vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
vec3 refractedRayExit = position + transmissionRay;
vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
vec2 refractionCoords = ndcPos.xy / ndcPos.w;
refractionCoords += 1.0;
refractionCoords /= 2.0;
vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
transmittedLight[ i ] = transmissionSample[ i ];
transmittedLight.a += transmissionSample.a;
transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
}
transmittedLight.a /= 3.0;
#else
vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
vec3 refractedRayExit = position + transmissionRay;
vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
vec2 refractionCoords = ndcPos.xy / ndcPos.w;
refractionCoords += 1.0;
refractionCoords /= 2.0;
transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
#endif
vec3 attenuatedColor = transmittance * transmittedLight.rgb;
vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
}
#endif`,h1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
varying vec2 vUv;
#endif
#ifdef USE_MAP
varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
uniform mat3 transmissionMapTransform;
varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
uniform mat3 thicknessMapTransform;
varying vec2 vThicknessMapUv;
#endif`,u1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
varying vec2 vUv;
#endif
#ifdef USE_MAP
uniform mat3 mapTransform;
varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
uniform mat3 alphaMapTransform;
varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
uniform mat3 lightMapTransform;
varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
uniform mat3 aoMapTransform;
varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
uniform mat3 bumpMapTransform;
varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
uniform mat3 normalMapTransform;
varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
uniform mat3 displacementMapTransform;
varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
uniform mat3 emissiveMapTransform;
varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
uniform mat3 metalnessMapTransform;
varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
uniform mat3 roughnessMapTransform;
varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
uniform mat3 diffuseRoughnessMapTransform;
varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
uniform mat3 anisotropyMapTransform;
varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
uniform mat3 clearcoatMapTransform;
varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
uniform mat3 clearcoatNormalMapTransform;
varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
uniform mat3 clearcoatRoughnessMapTransform;
varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
uniform mat3 sheenColorMapTransform;
varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
uniform mat3 sheenRoughnessMapTransform;
varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
uniform mat3 iridescenceMapTransform;
varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
uniform mat3 iridescenceThicknessMapTransform;
varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
uniform mat3 specularMapTransform;
varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
uniform mat3 specularColorMapTransform;
varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
uniform mat3 specularIntensityMapTransform;
varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
uniform mat3 transmissionMapTransform;
varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
uniform mat3 thicknessMapTransform;
varying vec2 vThicknessMapUv;
#endif`,d1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,f1=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
vec4 worldPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
worldPosition = batchingMatrix * worldPosition;
#endif
#ifdef USE_INSTANCING
worldPosition = instanceMatrix * worldPosition;
#endif
worldPosition = modelMatrix * worldPosition;
#endif`,p1=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,m1=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
vec4 texColor = texture2D( t2D, vUv );
#ifdef DECODE_VIDEO_TEXTURE
texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
#endif
texColor.rgb *= backgroundIntensity;
gl_FragColor = texColor;
#include <tonemapping_fragment>
#include <colorspace_fragment>
}`,g1=`varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
gl_Position.z = gl_Position.w;
}`,_1=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
#ifdef ENVMAP_TYPE_PMREM
vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
#else
vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
#endif
texColor.rgb *= backgroundIntensity;
gl_FragColor = texColor;
#include <tonemapping_fragment>
#include <colorspace_fragment>
}`,x1=`varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
gl_Position.z = gl_Position.w;
}`,y1=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
gl_FragColor = texColor;
gl_FragColor.a *= opacity;
#include <tonemapping_fragment>
#include <colorspace_fragment>
}`,v1=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
#include <uv_vertex>
#include <batching_vertex>
#include <skinbase_vertex>
#include <morphinstance_vertex>
#ifdef USE_DISPLACEMENTMAP
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinnormal_vertex>
#endif
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
vHighPrecisionZW = gl_Position.zw;
}`,S1=`#if DEPTH_PACKING == 3200
uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
vec4 diffuseColor = vec4( 1.0 );
#include <clipping_planes_fragment>
#if DEPTH_PACKING == 3200
diffuseColor.a = opacity;
#endif
#include <map_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <logdepthbuf_fragment>
#ifdef USE_REVERSED_DEPTH_BUFFER
float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
#else
float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
#endif
#if DEPTH_PACKING == 3200
gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
#elif DEPTH_PACKING == 3201
gl_FragColor = packDepthToRGBA( fragCoordZ );
#elif DEPTH_PACKING == 3202
gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
#elif DEPTH_PACKING == 3203
gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
#endif
}`,M1=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <batching_vertex>
#include <skinbase_vertex>
#include <morphinstance_vertex>
#ifdef USE_DISPLACEMENTMAP
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinnormal_vertex>
#endif
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <worldpos_vertex>
#include <clipping_planes_vertex>
vWorldPosition = worldPosition.xyz;
}`,b1=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( 1.0 );
#include <clipping_planes_fragment>
#include <map_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
float dist = length( vWorldPosition - referencePosition );
dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
dist = saturate( dist );
gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,w1=`varying vec3 vWorldDirection;
#include <common>
void main() {
vWorldDirection = transformDirection( position, modelMatrix );
#include <begin_vertex>
#include <project_vertex>
}`,E1=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
vec3 direction = normalize( vWorldDirection );
vec2 sampleUV = equirectUv( direction );
gl_FragColor = texture2D( tEquirect, sampleUV );
#include <tonemapping_fragment>
#include <colorspace_fragment>
}`,T1=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
vLineDistance = scale * lineDistance;
#include <uv_vertex>
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#include <fog_vertex>
}`,A1=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
if ( mod( vLineDistance, totalSize ) > dashSize ) {
discard;
}
vec3 outgoingLight = vec3( 0.0 );
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
outgoingLight = diffuseColor.rgb;
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
}`,R1=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <batching_vertex>
#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#endif
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#include <worldpos_vertex>
#include <envmap_vertex>
#include <fog_vertex>
}`,C1=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <specularmap_fragment>
ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
#ifdef USE_LIGHTMAP
vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
#else
reflectedLight.indirectDiffuse += vec3( 1.0 );
#endif
#include <aomap_fragment>
reflectedLight.indirectDiffuse *= diffuseColor.rgb;
vec3 outgoingLight = reflectedLight.indirectDiffuse;
#include <envmap_fragment>
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
#include <dithering_fragment>
}`,P1=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <normal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
vViewPosition = - mvPosition.xyz;
#include <worldpos_vertex>
#include <envmap_vertex>
#include <shadowmap_vertex>
#include <fog_vertex>
}`,I1=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
vec3 totalEmissiveRadiance = emissive;
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <specularmap_fragment>
#include <normal_fragment_begin>
#include <normal_fragment_maps>
#include <emissivemap_fragment>
#include <lights_lambert_fragment>
#include <lights_fragment_begin>
#include <lights_fragment_maps>
#include <lights_fragment_end>
#include <aomap_fragment>
vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
#include <envmap_fragment>
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
#include <dithering_fragment>
}`,L1=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <normal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#include <fog_vertex>
vViewPosition = - mvPosition.xyz;
}`,D1=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <normal_fragment_begin>
#include <normal_fragment_maps>
vec3 viewDir = normalize( vViewPosition );
vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
vec3 y = cross( viewDir, x );
vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
#ifdef USE_MATCAP
vec4 matcapColor = texture2D( matcap, uv );
#else
vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
#endif
vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
#include <dithering_fragment>
}`,N1=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphinstance_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <normal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
vViewPosition = - mvPosition.xyz;
#endif
}`,U1=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
#include <clipping_planes_fragment>
#include <logdepthbuf_fragment>
#include <normal_fragment_begin>
#include <normal_fragment_maps>
gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
#ifdef OPAQUE
gl_FragColor.a = 1.0;
#endif
}`,F1=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <color_vertex>
#include <morphcolor_vertex>
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphinstance_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <normal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
vViewPosition = - mvPosition.xyz;
#include <worldpos_vertex>
#include <envmap_vertex>
#include <shadowmap_vertex>
#include <fog_vertex>
}`,O1=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
vec3 totalEmissiveRadiance = emissive;
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <specularmap_fragment>
#include <normal_fragment_begin>
#include <normal_fragment_maps>
#include <emissivemap_fragment>
#include <lights_phong_fragment>
#include <lights_fragment_begin>
#include <lights_fragment_maps>
#include <lights_fragment_end>
#include <aomap_fragment>
vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
#include <envmap_fragment>
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
#include <dithering_fragment>
}`,B1=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <normal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
vViewPosition = - mvPosition.xyz;
#include <worldpos_vertex>
#include <shadowmap_vertex>
#include <fog_vertex>
#ifdef USE_TRANSMISSION
vWorldPosition = worldPosition.xyz;
#endif
}`,k1=`#define STANDARD
#ifdef PHYSICAL
#define IOR
#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
uniform float ior;
#endif
#ifdef USE_SPECULAR
uniform float specularIntensity;
uniform vec3 specularColor;
#ifdef USE_SPECULAR_COLORMAP
uniform sampler2D specularColorMap;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
uniform sampler2D specularIntensityMap;
#endif
#endif
#ifdef USE_CLEARCOAT
uniform float clearcoat;
uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
uniform float diffuseRoughness;
#ifdef USE_DIFFUSE_ROUGHNESSMAP
uniform sampler2D diffuseRoughnessMap;
#endif
#endif
#ifdef USE_DISPERSION
uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
uniform float iridescence;
uniform float iridescenceIOR;
uniform float iridescenceThicknessMinimum;
uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
uniform vec3 sheenColor;
uniform float sheenRoughness;
#ifdef USE_SHEEN_COLORMAP
uniform sampler2D sheenColorMap;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
uniform sampler2D sheenRoughnessMap;
#endif
#endif
#ifdef USE_ANISOTROPY
uniform vec2 anisotropyVector;
#ifdef USE_ANISOTROPYMAP
uniform sampler2D anisotropyMap;
#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
vec3 totalEmissiveRadiance = emissive;
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <roughnessmap_fragment>
#include <metalnessmap_fragment>
#include <normal_fragment_begin>
#include <normal_fragment_maps>
#include <clearcoat_normal_fragment_begin>
#include <clearcoat_normal_fragment_maps>
#include <emissivemap_fragment>
#include <lights_physical_fragment>
#include <lights_fragment_begin>
#include <lights_fragment_maps>
#include <lights_fragment_end>
#include <aomap_fragment>
vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
#include <transmission_fragment>
vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
#ifdef USE_SHEEN
 
outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
#ifdef USE_CLEARCOAT
float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
#endif
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
#include <dithering_fragment>
}`,z1=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <normal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <displacementmap_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
vViewPosition = - mvPosition.xyz;
#include <worldpos_vertex>
#include <shadowmap_vertex>
#include <fog_vertex>
}`,V1=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
vec3 totalEmissiveRadiance = emissive;
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <color_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
#include <normal_fragment_begin>
#include <normal_fragment_maps>
#include <emissivemap_fragment>
#include <lights_toon_fragment>
#include <lights_fragment_begin>
#include <lights_fragment_maps>
#include <lights_fragment_end>
#include <aomap_fragment>
vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
#include <dithering_fragment>
}`,G1=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
varying vec2 vUv;
uniform mat3 uvTransform;
#endif
void main() {
#ifdef USE_POINTS_UV
vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
#endif
#include <color_vertex>
#include <morphinstance_vertex>
#include <morphcolor_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <project_vertex>
gl_PointSize = size;
#ifdef USE_SIZEATTENUATION
bool isPerspective = isPerspectiveMatrix( projectionMatrix );
if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
#endif
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#include <worldpos_vertex>
#include <fog_vertex>
}`,H1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
vec3 outgoingLight = vec3( 0.0 );
#include <logdepthbuf_fragment>
#include <map_particle_fragment>
#include <color_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
outgoingLight = diffuseColor.rgb;
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
}`,W1=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
#include <batching_vertex>
#include <beginnormal_vertex>
#include <morphinstance_vertex>
#include <morphnormal_vertex>
#include <skinbase_vertex>
#include <skinnormal_vertex>
#include <defaultnormal_vertex>
#include <begin_vertex>
#include <morphtarget_vertex>
#include <skinning_vertex>
#include <project_vertex>
#include <logdepthbuf_vertex>
#include <worldpos_vertex>
#include <shadowmap_vertex>
#include <fog_vertex>
}`,q1=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
#include <logdepthbuf_fragment>
gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
#include <premultiplied_alpha_fragment>
}`,X1=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
#include <uv_vertex>
vec4 mvPosition = modelViewMatrix[ 3 ];
vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
#ifndef USE_SIZEATTENUATION
bool isPerspective = isPerspectiveMatrix( projectionMatrix );
if ( isPerspective ) scale *= - mvPosition.z;
#endif
vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
vec2 rotatedPosition;
rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
mvPosition.xy += rotatedPosition;
gl_Position = projectionMatrix * mvPosition;
#include <logdepthbuf_vertex>
#include <clipping_planes_vertex>
#include <fog_vertex>
}`,Y1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
vec4 diffuseColor = vec4( diffuse, opacity );
#include <clipping_planes_fragment>
vec3 outgoingLight = vec3( 0.0 );
#include <logdepthbuf_fragment>
#include <map_fragment>
#include <alphamap_fragment>
#include <alphatest_fragment>
#include <alphahash_fragment>
outgoingLight = diffuseColor.rgb;
#include <opaque_fragment>
#include <tonemapping_fragment>
#include <colorspace_fragment>
#include <fog_fragment>
}`,ft={alphahash_fragment:mM,alphahash_pars_fragment:gM,alphamap_fragment:_M,alphamap_pars_fragment:xM,alphatest_fragment:yM,alphatest_pars_fragment:vM,aomap_fragment:SM,aomap_pars_fragment:MM,batching_pars_vertex:bM,batching_vertex:wM,begin_vertex:EM,beginnormal_vertex:TM,bsdfs:AM,iridescence_fragment:RM,bumpmap_pars_fragment:CM,clipping_planes_fragment:PM,clipping_planes_pars_fragment:IM,clipping_planes_pars_vertex:LM,clipping_planes_vertex:DM,color_fragment:NM,color_pars_fragment:UM,color_pars_vertex:FM,color_vertex:OM,common:BM,defaultnormal_vertex:kM,displacementmap_pars_vertex:zM,displacementmap_vertex:VM,emissivemap_fragment:GM,emissivemap_pars_fragment:HM,colorspace_fragment:WM,colorspace_pars_fragment:qM,envmap_fragment:XM,envmap_common_pars_fragment:YM,envmap_pars_fragment:$M,envmap_pars_vertex:ZM,envmap_physical_pars_fragment:ob,envmap_vertex:jM,fog_vertex:JM,fog_pars_vertex:KM,fog_fragment:QM,fog_pars_fragment:eb,gradientmap_pars_fragment:tb,lightmap_pars_fragment:nb,lights_lambert_fragment:ib,lights_lambert_pars_fragment:sb,lights_pars_begin:rb,lights_toon_fragment:ab,lights_toon_pars_fragment:lb,lights_phong_fragment:cb,lights_phong_pars_fragment:hb,lights_physical_fragment:ub,lights_physical_pars_fragment:db,lights_fragment_begin:fb,lights_fragment_maps:pb,lights_fragment_end:mb,lightprobes_pars_fragment:gb,logdepthbuf_fragment:_b,logdepthbuf_pars_fragment:xb,logdepthbuf_pars_vertex:yb,logdepthbuf_vertex:vb,map_fragment:Sb,map_pars_fragment:Mb,map_particle_fragment:bb,map_particle_pars_fragment:wb,metalnessmap_fragment:Eb,metalnessmap_pars_fragment:Tb,morphinstance_vertex:Ab,morphcolor_vertex:Rb,morphnormal_vertex:Cb,morphtarget_pars_vertex:Pb,morphtarget_vertex:Ib,normal_fragment_begin:Lb,normal_fragment_maps:Db,normal_pars_fragment:Nb,normal_pars_vertex:Ub,normal_vertex:Fb,normalmap_pars_fragment:Ob,clearcoat_normal_fragment_begin:Bb,clearcoat_normal_fragment_maps:kb,clearcoat_pars_fragment:zb,iridescence_pars_fragment:Vb,opaque_fragment:Gb,packing:Hb,premultiplied_alpha_fragment:Wb,project_vertex:qb,dithering_fragment:Xb,dithering_pars_fragment:Yb,roughnessmap_fragment:$b,roughnessmap_pars_fragment:Zb,shadowmap_pars_fragment:jb,shadowmap_pars_vertex:Jb,shadowmap_vertex:Kb,shadowmask_pars_fragment:Qb,skinbase_vertex:e1,skinning_pars_vertex:t1,skinning_vertex:n1,skinnormal_vertex:i1,specularmap_fragment:s1,specularmap_pars_fragment:r1,tonemapping_fragment:o1,tonemapping_pars_fragment:a1,transmission_fragment:l1,transmission_pars_fragment:c1,uv_pars_fragment:h1,uv_pars_vertex:u1,uv_vertex:d1,worldpos_vertex:f1,background_vert:p1,background_frag:m1,backgroundCube_vert:g1,backgroundCube_frag:_1,cube_vert:x1,cube_frag:y1,depth_vert:v1,depth_frag:S1,distance_vert:M1,distance_frag:b1,equirect_vert:w1,equirect_frag:E1,linedashed_vert:T1,linedashed_frag:A1,meshbasic_vert:R1,meshbasic_frag:C1,meshlambert_vert:P1,meshlambert_frag:I1,meshmatcap_vert:L1,meshmatcap_frag:D1,meshnormal_vert:N1,meshnormal_frag:U1,meshphong_vert:F1,meshphong_frag:O1,meshphysical_vert:B1,meshphysical_frag:k1,meshtoon_vert:z1,meshtoon_frag:V1,points_vert:G1,points_frag:H1,shadow_vert:W1,shadow_frag:q1,sprite_vert:X1,sprite_frag:Y1},Ie={common:{diffuse:{value:new ht(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new rt},alphaMap:{value:null},alphaMapTransform:{value:new rt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new rt}},envmap:{envMap:{value:null},envMapRotation:{value:new rt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new rt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new rt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new rt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new rt},normalScale:{value:new Ke(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new rt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new rt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new rt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new rt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ht(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ht(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new rt},alphaTest:{value:0},uvTransform:{value:new rt}},sprite:{diffuse:{value:new ht(16777215)},opacity:{value:1},center:{value:new Ke(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new rt},alphaMap:{value:null},alphaMapTransform:{value:new rt},alphaTest:{value:0}}},ni={basic:{uniforms:Vn([Ie.common,Ie.specularmap,Ie.envmap,Ie.aomap,Ie.lightmap,Ie.fog]),vertexShader:ft.meshbasic_vert,fragmentShader:ft.meshbasic_frag},lambert:{uniforms:Vn([Ie.common,Ie.specularmap,Ie.envmap,Ie.aomap,Ie.lightmap,Ie.emissivemap,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.fog,Ie.lights,{emissive:{value:new ht(0)},envMapIntensity:{value:1}}]),vertexShader:ft.meshlambert_vert,fragmentShader:ft.meshlambert_frag},phong:{uniforms:Vn([Ie.common,Ie.specularmap,Ie.envmap,Ie.aomap,Ie.lightmap,Ie.emissivemap,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.fog,Ie.lights,{emissive:{value:new ht(0)},specular:{value:new ht(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ft.meshphong_vert,fragmentShader:ft.meshphong_frag},standard:{uniforms:Vn([Ie.common,Ie.envmap,Ie.aomap,Ie.lightmap,Ie.emissivemap,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.roughnessmap,Ie.metalnessmap,Ie.fog,Ie.lights,{emissive:{value:new ht(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag},toon:{uniforms:Vn([Ie.common,Ie.aomap,Ie.lightmap,Ie.emissivemap,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.gradientmap,Ie.fog,Ie.lights,{emissive:{value:new ht(0)}}]),vertexShader:ft.meshtoon_vert,fragmentShader:ft.meshtoon_frag},matcap:{uniforms:Vn([Ie.common,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.fog,{matcap:{value:null}}]),vertexShader:ft.meshmatcap_vert,fragmentShader:ft.meshmatcap_frag},points:{uniforms:Vn([Ie.points,Ie.fog]),vertexShader:ft.points_vert,fragmentShader:ft.points_frag},dashed:{uniforms:Vn([Ie.common,Ie.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ft.linedashed_vert,fragmentShader:ft.linedashed_frag},depth:{uniforms:Vn([Ie.common,Ie.displacementmap]),vertexShader:ft.depth_vert,fragmentShader:ft.depth_frag},normal:{uniforms:Vn([Ie.common,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,{opacity:{value:1}}]),vertexShader:ft.meshnormal_vert,fragmentShader:ft.meshnormal_frag},sprite:{uniforms:Vn([Ie.sprite,Ie.fog]),vertexShader:ft.sprite_vert,fragmentShader:ft.sprite_frag},background:{uniforms:{uvTransform:{value:new rt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ft.background_vert,fragmentShader:ft.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new rt}},vertexShader:ft.backgroundCube_vert,fragmentShader:ft.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ft.cube_vert,fragmentShader:ft.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ft.equirect_vert,fragmentShader:ft.equirect_frag},distance:{uniforms:Vn([Ie.common,Ie.displacementmap,{referencePosition:{value:new Y},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ft.distance_vert,fragmentShader:ft.distance_frag},shadow:{uniforms:Vn([Ie.lights,Ie.fog,{color:{value:new ht(0)},opacity:{value:1}}]),vertexShader:ft.shadow_vert,fragmentShader:ft.shadow_frag}};ni.physical={uniforms:Vn([ni.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new rt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new rt},clearcoatNormalScale:{value:new Ke(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new rt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new rt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new rt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new rt},sheen:{value:0},sheenColor:{value:new ht(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new rt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new rt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new rt},transmissionSamplerSize:{value:new Ke},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new rt},attenuationDistance:{value:0},attenuationColor:{value:new ht(0)},specularColor:{value:new ht(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new rt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new rt},anisotropyVector:{value:new Ke},anisotropyMap:{value:null},anisotropyMapTransform:{value:new rt}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag};var Zh={r:0,b:0,g:0},$1=new Bt,R_=new rt;R_.set(-1,0,0,0,1,0,0,0,1);function Z1(n,e,t,i,s,r){let o=new ht(0),a=s===!0?0:1,l,c,u=null,d=0,h=null;function m(v){let P=v.isScene===!0?v.background:null;if(P&&P.isTexture){let b=v.backgroundBlurriness>0;P=e.get(P,b)}return P}function g(v){let P=!1,b=m(v);b===null?f(o,a):b&&b.isColor&&(f(b,1),P=!0);let C=n.xr.getEnvironmentBlendMode();C==="additive"?t.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||P)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function _(v,P){let b=m(P);b&&b.isCubeTexture?(c===void 0&&(c=new zn(new js(1,1,1),new Ti({name:"BackgroundCubeMaterial",uniforms:Or(ni.backgroundCube.uniforms),vertexShader:ni.backgroundCube.vertexShader,fragmentShader:ni.backgroundCube.fragmentShader,side:ti,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,M,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=P.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=P.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4($1.makeRotationFromEuler(P.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(R_),c.material.toneMapped=St.getTransfer(b.colorSpace)!==Lt,(u!==b||d!==b.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=b,d=b.version,h=n.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new zn(new Lr(2,2),new Ti({name:"BackgroundMaterial",uniforms:Or(ni.background.uniforms),vertexShader:ni.background.vertexShader,fragmentShader:ni.background.fragmentShader,side:ir,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=P.backgroundIntensity,l.material.toneMapped=St.getTransfer(b.colorSpace)!==Lt,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(u!==b||d!==b.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=b,d=b.version,h=n.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function f(v,P){v.getRGB(Zh,Rf(n)),t.buffers.color.setClear(Zh.r,Zh.g,Zh.b,P,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,P=1){o.set(v),a=P,f(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,f(o,a)},render:g,addToRenderList:_,dispose:p}}function j1(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(I,U,k,E,N){let z=!1,O=d(I,E,k,U);r!==O&&(r=O,c(r.object)),z=m(I,E,k,N),z&&g(I,E,k,N),N!==null&&e.update(N,n.ELEMENT_ARRAY_BUFFER),(z||o)&&(o=!1,b(I,U,k,E),N!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(N).buffer))}function l(){return n.createVertexArray()}function c(I){return n.bindVertexArray(I)}function u(I){return n.deleteVertexArray(I)}function d(I,U,k,E){let N=E.wireframe===!0,z=i[U.id];z===void 0&&(z={},i[U.id]=z);let O=I.isInstancedMesh===!0?I.id:0,X=z[O];X===void 0&&(X={},z[O]=X);let H=X[k.id];H===void 0&&(H={},X[k.id]=H);let Z=H[N];return Z===void 0&&(Z=h(l()),H[N]=Z),Z}function h(I){let U=[],k=[],E=[];for(let N=0;N<t;N++)U[N]=0,k[N]=0,E[N]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:U,enabledAttributes:k,attributeDivisors:E,object:I,attributes:{},index:null}}function m(I,U,k,E){let N=r.attributes,z=U.attributes,O=0,X=k.getAttributes();for(let H in X)if(X[H].location>=0){let te=N[H],le=z[H];if(le===void 0&&(H==="instanceMatrix"&&I.instanceMatrix&&(le=I.instanceMatrix),H==="instanceColor"&&I.instanceColor&&(le=I.instanceColor)),te===void 0||te.attribute!==le||le&&te.data!==le.data)return!0;O++}return r.attributesNum!==O||r.index!==E}function g(I,U,k,E){let N={},z=U.attributes,O=0,X=k.getAttributes();for(let H in X)if(X[H].location>=0){let te=z[H];te===void 0&&(H==="instanceMatrix"&&I.instanceMatrix&&(te=I.instanceMatrix),H==="instanceColor"&&I.instanceColor&&(te=I.instanceColor));let le={};le.attribute=te,te&&te.data&&(le.data=te.data),N[H]=le,O++}r.attributes=N,r.attributesNum=O,r.index=E}function _(){let I=r.newAttributes;for(let U=0,k=I.length;U<k;U++)I[U]=0}function f(I){p(I,0)}function p(I,U){let k=r.newAttributes,E=r.enabledAttributes,N=r.attributeDivisors;k[I]=1,E[I]===0&&(n.enableVertexAttribArray(I),E[I]=1),N[I]!==U&&(n.vertexAttribDivisor(I,U),N[I]=U)}function v(){let I=r.newAttributes,U=r.enabledAttributes;for(let k=0,E=U.length;k<E;k++)U[k]!==I[k]&&(n.disableVertexAttribArray(k),U[k]=0)}function P(I,U,k,E,N,z,O){O===!0?n.vertexAttribIPointer(I,U,k,N,z):n.vertexAttribPointer(I,U,k,E,N,z)}function b(I,U,k,E){_();let N=E.attributes,z=k.getAttributes(),O=U.defaultAttributeValues;for(let X in z){let H=z[X];if(H.location>=0){let Z=N[X];if(Z===void 0&&(X==="instanceMatrix"&&I.instanceMatrix&&(Z=I.instanceMatrix),X==="instanceColor"&&I.instanceColor&&(Z=I.instanceColor)),Z!==void 0){let te=Z.normalized,le=Z.itemSize,he=e.get(Z);if(he===void 0)continue;let Q=he.buffer,me=he.type,ge=he.bytesPerElement,oe=me===n.INT||me===n.UNSIGNED_INT||Z.gpuType===uh;if(Z.isInterleavedBufferAttribute){let de=Z.data,Ne=de.isInterleavedBuffer===!0?de.stride:de.itemSize,Ye=Z.offset;if(de.isInstancedInterleavedBuffer||de.isInstancedBufferAttribute){for(let Be=0;Be<H.locationSize;Be++)p(H.location+Be,de.meshPerAttribute);I.isInstancedMesh!==!0&&E._maxInstanceCount===void 0&&(E._maxInstanceCount=de.meshPerAttribute*de.count)}else for(let Be=0;Be<H.locationSize;Be++)f(H.location+Be);n.bindBuffer(n.ARRAY_BUFFER,Q);for(let Be=0;Be<H.locationSize;Be++)P(H.location+Be,le/H.locationSize,me,te,Ne*ge,(Ye+le/H.locationSize*Be)*ge,oe)}else{if(Z.isInstancedBufferAttribute){for(let de=0;de<H.locationSize;de++)p(H.location+de,Z.meshPerAttribute);I.isInstancedMesh!==!0&&E._maxInstanceCount===void 0&&(E._maxInstanceCount=Z.meshPerAttribute*Z.count)}else for(let de=0;de<H.locationSize;de++)f(H.location+de);n.bindBuffer(n.ARRAY_BUFFER,Q);for(let de=0;de<H.locationSize;de++)P(H.location+de,le/H.locationSize,me,te,le*ge,le/H.locationSize*de*ge,oe)}}else if(O!==void 0){let te=O[X];if(te!==void 0)switch(te.length){case 2:n.vertexAttrib2fv(H.location,te);break;case 3:n.vertexAttrib3fv(H.location,te);break;case 4:n.vertexAttrib4fv(H.location,te);break;default:n.vertexAttrib1fv(H.location,te)}}}}v()}function C(){L();for(let I in i){let U=i[I];for(let k in U){let E=U[k];for(let N in E){let z=E[N];for(let O in z)u(z[O].object),delete z[O];delete E[N]}}delete i[I]}}function M(I){if(i[I.id]===void 0)return;let U=i[I.id];for(let k in U){let E=U[k];for(let N in E){let z=E[N];for(let O in z)u(z[O].object),delete z[O];delete E[N]}}delete i[I.id]}function x(I){for(let U in i){let k=i[U];for(let E in k){let N=k[E];if(N[I.id]===void 0)continue;let z=N[I.id];for(let O in z)u(z[O].object),delete z[O];delete N[I.id]}}}function y(I){for(let U in i){let k=i[U],E=I.isInstancedMesh===!0?I.id:0,N=k[E];if(N!==void 0){for(let z in N){let O=N[z];for(let X in O)u(O[X].object),delete O[X];delete N[z]}delete k[E],Object.keys(k).length===0&&delete i[U]}}}function L(){R(),o=!0,r!==s&&(r=s,c(r.object))}function R(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:L,resetDefaultState:R,dispose:C,releaseStatesOfGeometry:M,releaseStatesOfObject:y,releaseStatesOfProgram:x,initAttributes:_,enableAttribute:f,disableUnusedAttributes:v}}function J1(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let h=0;for(let m=0;m<u;m++)h+=c[m];t.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function K1(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==qi&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let y=x===Wi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==si&&x!==Hi&&!y&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(je("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),h=t.logarithmicDepthBuffer===!0&&d===!1;t.reversedDepthBuffer===!0&&d===!1&&je("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&d===!0&&je("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let m=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_TEXTURE_SIZE),f=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),v=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),P=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),C=n.getParameter(n.MAX_SAMPLES),M=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:d,maxTextures:m,maxVertexTextures:g,maxTextureSize:_,maxCubemapSize:f,maxAttributes:p,maxVertexUniforms:v,maxVaryings:P,maxFragmentUniforms:b,maxSamples:C,samples:M}}function Q1(n){let e=this,t=null,i=0,s=!1,r=!1,o=new gi,a=new rt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,h){let m=d.length!==0||h||i!==0||s;return s=h,i=d.length,m},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,h){t=u(d,h,0)},this.setState=function(d,h,m){let g=d.clippingPlanes,_=d.clipIntersection,f=d.clipShadows,p=n.get(d);if(!s||g===null||g.length===0||r&&!f)r?u(null):c();else{let v=r?0:i,P=v*4,b=p.clippingState||null;l.value=b,b=u(g,h,P,m);for(let C=0;C!==P;++C)b[C]=t[C];p.clippingState=b,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(d,h,m,g){let _=d!==null?d.length:0,f=null;if(_!==0){if(f=l.value,g!==!0||f===null){let p=m+_*4,v=h.matrixWorldInverse;a.getNormalMatrix(v),(f===null||f.length<p)&&(f=new Float32Array(p));for(let P=0,b=m;P!==_;++P,b+=4)o.copy(d[P]).applyMatrix4(v,a),o.normal.toArray(f,b),f[b+3]=o.constant}l.value=f,l.needsUpdate=!0}return e.numPlanes=_,e.numIntersection=0,f}}var gl=class extends _i{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new za(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new js(5,5,5),r=new Ti({name:"CubemapFromEquirect",uniforms:Or(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:ti,blending:Dr});r.uniforms.tEquirect.value=t;let o=new zn(s,r),a=t.minFilter;return t.minFilter===Cs&&(t.minFilter=Kn),new Go(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},o_=256,ew=3,tw=20,C_=256,P_=16,nw=3,iw=new Y,sw=new ht,Jh=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Go(1,10,null),this._boxMesh=new zn(new js(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=iw}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,h=l.autoClearColor,m=l.autoClearDepth,g=l.autoClearStencil,_=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,_===null&&(e.background=l.getClearColor(sw));let f=new Go(i,s,u);return f.position.copy(a),f.update(l,e),l.autoClear=d,l.autoClearColor=h,l.autoClearDepth=m,l.autoClearStencil=g,e.background=_,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=c_(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=l_(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(o_,Ef(e))}_fromTexture(e,t){e.mapping===Ur||e.mapping===Xo?this._setSize(e.image.length===0?o_:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=a_(e,!1,!1),i=Math.log2(e)-ew;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=a_(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Ur||e.mapping===Xo?(this._cubemapMaterial===null&&(this._cubemapMaterial=c_()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=l_()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=rw(),this._integrationMaterial=ow());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/P_);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-nw)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(C_*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=aw());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function a_(n,e,t){return new gl(n,{minFilter:Cs,generateMipmaps:e,type:Wi,colorSpace:Pa,depthBuffer:t})}function _l(n,e,t){return new Ti({name:n,uniforms:e,vertexShader:ft.cube_vert,fragmentShader:t,side:ti,blending:Dr,depthTest:!1,depthWrite:!1})}function rw(){return _l("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${C_}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function ow(){return _l("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:P_}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function aw(){return _l("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${tw}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function l_(){return _l("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function c_(){return _l("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function lw(n){let e=new WeakMap,t=new WeakMap,i=null;function s(h,m=!1){return h==null?null:m?o(h):r(h)}function r(h){if(h&&h.isTexture){let m=h.mapping;if(m===lh||m===ch)if(e.has(h)){let g=e.get(h).texture;return a(g,h.mapping)}else{let g=h.image;if(g&&g.height>0){let _=new gl(g.height);return _.fromEquirectangularTexture(n,h),e.set(h,_),h.addEventListener("dispose",c),a(_.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let m=h.mapping,g=m===lh||m===ch,_=m===Ur||m===Xo;if(g||_){let f=t.get(h),p=f!==void 0?f.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==p)return i===null&&(i=new Jh(n)),f=g?i.fromEquirectangular(h,f):i.fromCubemap(h,f),f.texture.pmremVersion=h.pmremVersion,t.set(h,f),f.texture;if(f!==void 0)return f.texture;{let v=h.image;return g&&v&&v.height>0||_&&v&&l(v)?(i===null&&(i=new Jh(n)),f=g?i.fromEquirectangular(h):i.fromCubemap(h),f.texture.pmremVersion=h.pmremVersion,t.set(h,f),h.addEventListener("dispose",u),f.texture):null}}}return h}function a(h,m){return m===lh?h.mapping=Ur:m===ch&&(h.mapping=Xo),h}function l(h){let m=0,g=6;for(let _=0;_<g;_++)h[_]!==void 0&&m++;return m===g}function c(h){let m=h.target;m.removeEventListener("dispose",c);let g=e.get(m);g!==void 0&&(e.delete(m),g.dispose())}function u(h){let m=h.target;m.removeEventListener("dispose",u);let g=t.get(m);g!==void 0&&(t.delete(m),g.dispose())}function d(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:d}}function cw(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&Ta("WebGLRenderer: "+i+" extension not supported."),s}}}function hw(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let f in g.attributes)e.remove(g.attributes[f]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let _=r.get(g);_&&(e.remove(_),r.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,_){return s[_.id]!==void 0||(_.addEventListener("dispose",a),s[_.id]=new WeakRef(_),o.register(_,_.id,_),t.memory.geometries++),_}function u(g){let _=g.attributes;for(let f in _)e.update(_[f],n.ARRAY_BUFFER)}function d(g){let _=g.index,f=g.attributes.position,p=0;if(f===void 0)return;let v=_!==null?_.array.length:f.array.length/3-1,P=f.count>=65535?Ba:Oa,b=new P(Math.ceil(v/3)*6,1),C=b.array;if(_!==null){let x=_.array;p=_.version;for(let y=0,L=0;y<v;y+=3){let R=x[y+0],I=x[y+1],U=x[y+2];C[L++]=R,C[L++]=I,C[L++]=I,C[L++]=U,C[L++]=U,C[L++]=R}}else{p=f.version;for(let x=0,y=0;x<v;x+=3){let L=x+0,R=x+1,I=x+2;C[y++]=L,C[y++]=R,C[y++]=R,C[y++]=I,C[y++]=I,C[y++]=L}}b.version=p;let M=r.get(g);M&&e.remove(M),r.set(g,b)}function h(g){let _=r.get(g);if(_){let f=g.index;f!==null&&_.version<f.version&&d(g)}else d(g);return r.get(g)}function m(){for(let g in s){let _=s[g].deref();_!==void 0&&l(_)}}return{get:c,update:u,getWireframeAttribute:h,dispose:m}}function uw(n,e,t){let i;function s(d){i=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,h){n.drawElements(i,h,r,d*o),t.update(h,i,1)}function c(d,h,m){m!==0&&(n.drawElementsInstanced(i,h,r,d*o,m),t.update(h,i,m))}function u(d,h,m){if(m===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,d,0,m);let _=0;for(let f=0;f<m;f++)_+=h[f];t.update(_,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function dw(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:it("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function fw(n,e,t){let i=new WeakMap,s=new Dt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=u!==void 0?u.length:0,h=i.get(a);if(h===void 0||h.count!==d){let L=function(){x.dispose(),i.delete(a),a.removeEventListener("dispose",L)};h!==void 0&&h.texture.dispose();let m=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,f=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],P=0;m===!0&&(P=1),g===!0&&(P=2),_===!0&&(P=3);let b=a.attributes.position.count*P,C=1;b>e.maxTextureSize&&(C=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let M=new Float32Array(b*C*4*d),x=new Na(M,b,C,d);x.type=Hi,x.needsUpdate=!0;let y=P*4;for(let R=0;R<d;R++){let I=f[R],U=p[R],k=v[R],E=b*C*4*R;for(let N=0;N<I.count;N++){let z=N*y;m===!0&&(s.fromBufferAttribute(I,N),M[E+z+0]=s.x,M[E+z+1]=s.y,M[E+z+2]=s.z,M[E+z+3]=0),g===!0&&(s.fromBufferAttribute(U,N),M[E+z+4]=s.x,M[E+z+5]=s.y,M[E+z+6]=s.z,M[E+z+7]=0),_===!0&&(s.fromBufferAttribute(k,N),M[E+z+8]=s.x,M[E+z+9]=s.y,M[E+z+10]=s.z,M[E+z+11]=k.itemSize===4?s.w:1)}}h={count:d,texture:x,size:new Ke(b,C)},i.set(a,h),a.addEventListener("dispose",L)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let m=0;for(let _=0;_<c.length;_++)m+=c[_];let g=a.morphTargetsRelative?1:1-m;l.getUniforms().setValue(n,"morphTargetBaseInfluence",g),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function pw(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,d=c.geometry,h=e.get(c,d);if(r.get(h)!==u&&(e.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let m=c.skeleton;r.get(m)!==u&&(m.update(),r.set(m,u))}return h}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var mw={[sf]:"LINEAR_TONE_MAPPING",[rf]:"REINHARD_TONE_MAPPING",[of]:"CINEON_TONE_MAPPING",[af]:"ACES_FILMIC_TONE_MAPPING",[cf]:"AGX_TONE_MAPPING",[hf]:"NEUTRAL_TONE_MAPPING",[lf]:"CUSTOM_TONE_MAPPING"};function gw(n,e,t,i,s,r){let o=new _i(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new ii;u.setAttribute("position",new Ht([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Ht([0,2,0,0,2,0],2));let d=new Xc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),h=new zn(u,d),m=new Ka(-1,1,1,-1,0,1),g=null,_=null,f=!1,p,v=null,P=[],b=!1;this.setSize=function(C,M){o.setSize(C,M),a!==null&&a.setSize(C,M),l!==null&&l.setSize(C,M);for(let x=0;x<P.length;x++){let y=P[x];y.setSize&&y.setSize(C,M)}},this.setEffects=function(C){P=C,b=P.length>0&&P[0].isRenderPass===!0;let M=o.width,x=o.height;P.length>0&&a===null&&(a=new _i(M,x,{type:Wi,depthBuffer:!1,stencilBuffer:!1}),l=new _i(M,x,{type:Wi,depthBuffer:!1,stencilBuffer:!1}));let y=s===!0&&P.some(L=>L.needsDepthTexture===!0);y!==(o.depthTexture!==null)&&(y===!0&&c===null&&(c=new Rs(M,x),r===!0&&(c.format=Ps,c.type=Fr)),o.dispose(),o.depthTexture=y?c:null,o.resolveDepthBuffer=y,o.storeMultisampledDepthBuffer=y);for(let L=0;L<P.length;L++){let R=P[L];R.setSize&&R.setSize(M,x),y&&R.needsDepthTexture===!0&&R.setDepthTexture&&R.setDepthTexture(c)}},this.begin=function(C,M){if(f||C.toneMapping===os&&P.length===0)return!1;if(v=M,M!==null){let x=M.width,y=M.height;(o.width!==x||o.height!==y)&&this.setSize(x,y)}return b===!1&&C.setRenderTarget(o),p=C.toneMapping,C.toneMapping=os,!0},this.hasRenderPass=function(){return b},this.end=function(C,M){C.toneMapping=p,f=!0;let x=o,y=a;for(let L=0;L<P.length;L++){let R=P[L];R.enabled!==!1&&(R.render(C,y,x,M),R.needsSwap!==!1&&(x=y,y=y===a?l:a))}if(g!==C.outputColorSpace||_!==C.toneMapping){g=C.outputColorSpace,_=C.toneMapping,d.defines={},St.getTransfer(g)===Lt&&(d.defines.SRGB_TRANSFER="");let L=mw[_];L&&(d.defines[L]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=x.texture,C.setRenderTarget(v),C.render(h,m),v=null,f=!1},this.isCompositing=function(){return f},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),d.dispose()}}var I_=new ei,L_=new Rs(1,1),D_=new Ga(1),N_=new Na,U_=new Oc,F_=new za,h_=[],u_=[],d_=new Float32Array(16),f_=new Float32Array(9),p_=new Float32Array(4);function Zo(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=h_[s];if(r===void 0&&(r=new Float32Array(s),h_[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function Mn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function bn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Qh(n,e){let t=u_[e];t===void 0&&(t=new Int32Array(e),u_[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function _w(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function xw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Mn(t,e))return;n.uniform2fv(this.addr,e),bn(t,e)}}function yw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Mn(t,e))return;n.uniform3fv(this.addr,e),bn(t,e)}}function vw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Mn(t,e))return;n.uniform4fv(this.addr,e),bn(t,e)}}function Sw(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Mn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),bn(t,e)}else{if(Mn(t,i))return;p_.set(i),n.uniformMatrix2fv(this.addr,!1,p_),bn(t,i)}}function Mw(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Mn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),bn(t,e)}else{if(Mn(t,i))return;f_.set(i),n.uniformMatrix3fv(this.addr,!1,f_),bn(t,i)}}function bw(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Mn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),bn(t,e)}else{if(Mn(t,i))return;d_.set(i),n.uniformMatrix4fv(this.addr,!1,d_),bn(t,i)}}function ww(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function Ew(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Mn(t,e))return;n.uniform2iv(this.addr,e),bn(t,e)}}function Tw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Mn(t,e))return;n.uniform3iv(this.addr,e),bn(t,e)}}function Aw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Mn(t,e))return;n.uniform4iv(this.addr,e),bn(t,e)}}function Rw(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function Cw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Mn(t,e))return;n.uniform2uiv(this.addr,e),bn(t,e)}}function Pw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Mn(t,e))return;n.uniform3uiv(this.addr,e),bn(t,e)}}function Iw(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Mn(t,e))return;n.uniform4uiv(this.addr,e),bn(t,e)}}function eu(n){return n.version===0&&(n.compareFunction=Sf,n.needsUpdate=!0),n}function Lw(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=eu(L_):r=I_,t.setTexture2D(e||r,s)}function Dw(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||U_,s)}function Nw(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=eu(D_):r=F_,t.setTextureCube(e||r,s)}function Uw(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||N_,s)}function Fw(n){switch(n){case 5126:return _w;case 35664:return xw;case 35665:return yw;case 35666:return vw;case 35674:return Sw;case 35675:return Mw;case 35676:return bw;case 5124:case 35670:return ww;case 35667:case 35671:return Ew;case 35668:case 35672:return Tw;case 35669:case 35673:return Aw;case 5125:return Rw;case 36294:return Cw;case 36295:return Pw;case 36296:return Iw;case 35678:case 36198:case 36298:case 36306:case 35682:return Lw;case 35679:case 36299:case 36307:return Dw;case 35680:case 36300:case 36308:case 36293:return Nw;case 36289:case 36303:case 36311:case 36292:return Uw}}function Ow(n,e){n.uniform1fv(this.addr,e)}function Bw(n,e){let t=Zo(e,this.size,2);n.uniform2fv(this.addr,t)}function kw(n,e){let t=Zo(e,this.size,3);n.uniform3fv(this.addr,t)}function zw(n,e){let t=Zo(e,this.size,4);n.uniform4fv(this.addr,t)}function Vw(n,e){let t=Zo(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function Gw(n,e){let t=Zo(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function Hw(n,e){let t=Zo(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function Ww(n,e){n.uniform1iv(this.addr,e)}function qw(n,e){n.uniform2iv(this.addr,e)}function Xw(n,e){n.uniform3iv(this.addr,e)}function Yw(n,e){n.uniform4iv(this.addr,e)}function $w(n,e){n.uniform1uiv(this.addr,e)}function Zw(n,e){n.uniform2uiv(this.addr,e)}function jw(n,e){n.uniform3uiv(this.addr,e)}function Jw(n,e){n.uniform4uiv(this.addr,e)}function Kw(n,e,t){let i=this.cache,s=e.length,r=Qh(t,s);Mn(i,r)||(n.uniform1iv(this.addr,r),bn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=eu(L_):o=I_;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function Qw(n,e,t){let i=this.cache,s=e.length,r=Qh(t,s);Mn(i,r)||(n.uniform1iv(this.addr,r),bn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||U_,r[o])}function eE(n,e,t){let i=this.cache,s=e.length,r=Qh(t,s);Mn(i,r)||(n.uniform1iv(this.addr,r),bn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=eu(D_):o=F_;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function tE(n,e,t){let i=this.cache,s=e.length,r=Qh(t,s);Mn(i,r)||(n.uniform1iv(this.addr,r),bn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||N_,r[o])}function nE(n){switch(n){case 5126:return Ow;case 35664:return Bw;case 35665:return kw;case 35666:return zw;case 35674:return Vw;case 35675:return Gw;case 35676:return Hw;case 5124:case 35670:return Ww;case 35667:case 35671:return qw;case 35668:case 35672:return Xw;case 35669:case 35673:return Yw;case 5125:return $w;case 36294:return Zw;case 36295:return jw;case 36296:return Jw;case 35678:case 36198:case 36298:case 36306:case 35682:return Kw;case 35679:case 36299:case 36307:return Qw;case 35680:case 36300:case 36308:case 36293:return eE;case 36289:case 36303:case 36311:case 36292:return tE}}var kf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=Fw(t.type)}},zf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=nE(t.type)}},Vf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},Of=/(\w+)(\])?(\[|\.)?/g;function m_(n,e){n.seq.push(e),n.map[e.id]=e}function iE(n,e,t){let i=n.name,s=i.length;for(Of.lastIndex=0;;){let r=Of.exec(i),o=Of.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){m_(t,c===void 0?new kf(a,n,e):new zf(a,n,e));break}else{let d=t.map[a];d===void 0&&(d=new Vf(a),m_(t,d)),t=d}}}var $o=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);iE(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function g_(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var sE=37297,rE=0;function oE(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var __=new rt;function aE(n){St._getMatrix(__,St.workingColorSpace,n);let e=`mat3( ${__.elements.map(t=>t.toFixed(4))} )`;switch(St.getTransfer(n)){case Ia:return[e,"LinearTransferOETF"];case Lt:return[e,"sRGBTransferOETF"];default:return je("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function x_(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+oE(n.getShaderSource(e),a)}else return r}function lE(n,e){let t=aE(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var cE={[sf]:"Linear",[rf]:"Reinhard",[of]:"Cineon",[af]:"ACESFilmic",[cf]:"AgX",[hf]:"Neutral",[lf]:"Custom"};function hE(n,e){let t=cE[e];return t===void 0?(je("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var jh=new Y;function uE(){St.getLuminanceCoefficients(jh);let n=jh.x.toFixed(4),e=jh.y.toFixed(4),t=jh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function dE(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(ml).join(`
`)}function fE(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function pE(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function ml(n){return n!==""}function y_(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function v_(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var mE=/^[ \t]*#include +<([\w\d./]+)>/gm;function Gf(n){return n.replace(mE,gE)}function gE(n,e){let t=ft[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Gf(t)}var _E=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function S_(n){return n.replace(_E,xE)}function xE(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function M_(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var yE={[sl]:"SHADOWMAP_TYPE_PCF",[Wo]:"SHADOWMAP_TYPE_VSM"};function vE(n){return yE[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var SE={[Xo]:"ENVMAP_MODE_REFRACTION"};function ME(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":SE[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var bE={[nf]:"ENVMAP_BLENDING_MULTIPLY",[G0]:"ENVMAP_BLENDING_MIX",[H0]:"ENVMAP_BLENDING_ADD"};function wE(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":bE[n.combine]||"ENVMAP_BLENDING_NONE"}function EE(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=vE(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=ME(t),d=wE(t),h=dE(t),m=fE(r),g=s.createProgram(),_,f,p=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(_=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m].filter(ml).join(`
`),_.length>0&&(_+=`
`),f=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m].filter(ml).join(`
`),f.length>0&&(f+=`
`)):(_=[M_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(ml).join(`
`),f=[M_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+d:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==os?"#define TONE_MAPPING":"",t.toneMapping!==os?ft.tonemapping_pars_fragment:"",t.toneMapping!==os?hE("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ft.colorspace_pars_fragment,lE("linearToOutputTexel",t.outputColorSpace),uE(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(ml).join(`
`)),o=Gf(o),o=y_(o,t),o=v_(o,t),a=Gf(a),a=y_(a,t),a=v_(a,t),o=S_(o),a=S_(a),t.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,_=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,f=["#define varying in",t.glslVersion===bf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===bf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+f);let v=p+_+o,P=p+f+a,b=g_(s,s.VERTEX_SHADER,v),C=g_(s,s.FRAGMENT_SHADER,P);s.attachShader(g,b),s.attachShader(g,C),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function M(R){if(n.debug.checkShaderErrors){let I=s.getProgramInfoLog(g)||"",U=s.getShaderInfoLog(b)||"",k=s.getShaderInfoLog(C)||"",E=I.trim(),N=U.trim(),z=k.trim(),O=!0,X=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(O=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,g,b,C);else{let H=x_(s,b,"vertex"),Z=x_(s,C,"fragment");it("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+R.name+`
Material Type: `+R.type+`

Program Info Log: `+E+`
`+H+`
`+Z)}else E!==""?je("WebGLProgram: Program Info Log:",E):(N===""||z==="")&&(X=!1);X&&(R.diagnostics={runnable:O,programLog:E,vertexShader:{log:N,prefix:_},fragmentShader:{log:z,prefix:f}})}s.deleteShader(b),s.deleteShader(C),x=new $o(s,g),y=pE(s,g)}let x;this.getUniforms=function(){return x===void 0&&M(this),x};let y;this.getAttributes=function(){return y===void 0&&M(this),y};let L=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return L===!1&&(L=s.getProgramParameter(g,sE)),L},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=rE++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=b,this.fragmentShader=C,this}var TE=0,Hf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Wf(e),t.set(e,i)),i}},Wf=class{constructor(e){this.id=TE++,this.code=e,this.usedTimes=0}};function AE(n){return n===sr||n===hl||n===ul}function RE(n,e,t,i,s,r){let o=new Ua,a=new Hf,l=new Set,c=[],u=new Map,d=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function m(x){return l.add(x),x===0?"uv":`uv${x}`}function g(x,y,L,R,I,U){let k=R.fog,E=I.geometry,N=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?R.environment:null,z=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,O=e.get(x.envMap||N,z),X=h[x.type],H=i.precision;x.precision!==null&&(H=i.getMaxPrecision(x.precision),H!==x.precision&&je("WebGLProgram.getParameters:",x.precision,"not supported, using",H,"instead."));let Z=E.morphAttributes.position||E.morphAttributes.normal||E.morphAttributes.color,te=Z!==void 0?Z.length:0,le=0;E.morphAttributes.position!==void 0&&(le=1),E.morphAttributes.normal!==void 0&&(le=2),E.morphAttributes.color!==void 0&&(le=3);let he,Q,me,ge;if(X){let Ce=ni[X];he=Ce.vertexShader,Q=Ce.fragmentShader}else{he=x.vertexShader,Q=x.fragmentShader;let Ce=a.getVertexShaderStage(x),ut=a.getFragmentShaderStage(x);a.update(x,Ce,ut),me=Ce.id,ge=ut.id}let oe=n.getRenderTarget(),de=n.state.buffers.depth.getReversed(),Ne=I.isInstancedMesh===!0,Ye=I.isBatchedMesh===!0,Be=!!x.map,st=!!x.matcap,at=!!O,$e=at&&O.isPMREMTexture===!0,pt=!!x.aoMap,Mt=!!x.lightMap,jt=!!x.bumpMap&&x.wireframe===!1,Pt=!!x.normalMap,rn=!!x.displacementMap,bt=!!x.emissiveMap,xn=!!x.metalnessMap,Qt=!!x.roughnessMap,ln=x.anisotropy>0,G=x.clearcoat>0,Pe=x.diffuseRoughness>0,Je=x.dispersion>0,lt=x.retroreflectivity>0,Ee=x.iridescence>0,zt=x.sheen>0,We=x.transmission>0,Ze=ln&&!!x.anisotropyMap,D=G&&!!x.clearcoatMap,w=G&&!!x.clearcoatNormalMap,j=G&&!!x.clearcoatRoughnessMap,pe=Pe&&!!x.diffuseRoughnessMap,ce=Ee&&!!x.iridescenceMap,ve=Ee&&!!x.iridescenceThicknessMap,Se=zt&&!!x.sheenColorMap,ie=zt&&!!x.sheenRoughnessMap,re=!!x.specularMap,xe=!!x.specularColorMap,V=!!x.specularIntensityMap,ae=We&&!!x.transmissionMap,se=We&&!!x.thicknessMap,Te=!!x.gradientMap,ye=!!x.alphaMap,we=x.alphaTest>0,qe=!!x.alphaHash,et=!!x.extensions,fe=os;x.toneMapped&&(oe===null||oe.isXRRenderTarget===!0)&&(fe=n.toneMapping);let Ve=$e?O.isCompressedCubeTexture?O.image[0].mipmaps:O.mipmaps:null,tt={shaderID:X,shaderType:x.type,shaderName:x.name,vertexShader:he,fragmentShader:Q,defines:x.defines,customVertexShaderID:me,customFragmentShaderID:ge,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:H,batching:Ye,batchingColor:Ye&&I._colorsTexture!==null,instancing:Ne,instancingColor:Ne&&I.instanceColor!==null,instancingMorph:Ne&&I.morphTexture!==null,outputColorSpace:oe===null?n.outputColorSpace:oe.isXRRenderTarget===!0?oe.texture.colorSpace:St.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Be,matcap:st,envMap:at,envMapMode:at&&O.mapping,envMapPMREM:$e,envMapMaxLod:$e?Ve.length-1:null,envMapSize:$e?Ve[0].width:null,aoMap:pt,lightMap:Mt,bumpMap:jt,normalMap:Pt,displacementMap:rn,emissiveMap:bt,normalMapObjectSpace:Pt&&x.normalMapType===X0,normalMapTangentSpace:Pt&&x.normalMapType===Yh,packedNormalMap:Pt&&x.normalMapType===Yh&&AE(x.normalMap.format),metalnessMap:xn,roughnessMap:Qt,anisotropy:ln,anisotropyMap:Ze,clearcoat:G,clearcoatMap:D,clearcoatNormalMap:w,clearcoatRoughnessMap:j,diffuseRoughness:Pe,diffuseRoughnessMap:pe,dispersion:Je,retroreflection:lt,iridescence:Ee,iridescenceMap:ce,iridescenceThicknessMap:ve,sheen:zt,sheenColorMap:Se,sheenRoughnessMap:ie,specularMap:re,specularColorMap:xe,specularIntensityMap:V,transmission:We,transmissionMap:ae,thicknessMap:se,gradientMap:Te,opaque:x.transparent===!1&&x.blending===qo&&x.alphaToCoverage===!1,alphaMap:ye,alphaTest:we,alphaHash:qe,combine:x.combine,mapUv:Be&&m(x.map.channel),aoMapUv:pt&&m(x.aoMap.channel),lightMapUv:Mt&&m(x.lightMap.channel),bumpMapUv:jt&&m(x.bumpMap.channel),normalMapUv:Pt&&m(x.normalMap.channel),displacementMapUv:rn&&m(x.displacementMap.channel),emissiveMapUv:bt&&m(x.emissiveMap.channel),metalnessMapUv:xn&&m(x.metalnessMap.channel),roughnessMapUv:Qt&&m(x.roughnessMap.channel),anisotropyMapUv:Ze&&m(x.anisotropyMap.channel),clearcoatMapUv:D&&m(x.clearcoatMap.channel),clearcoatNormalMapUv:w&&m(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:j&&m(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:pe&&m(x.diffuseRoughnessMap.channel),iridescenceMapUv:ce&&m(x.iridescenceMap.channel),iridescenceThicknessMapUv:ve&&m(x.iridescenceThicknessMap.channel),sheenColorMapUv:Se&&m(x.sheenColorMap.channel),sheenRoughnessMapUv:ie&&m(x.sheenRoughnessMap.channel),specularMapUv:re&&m(x.specularMap.channel),specularColorMapUv:xe&&m(x.specularColorMap.channel),specularIntensityMapUv:V&&m(x.specularIntensityMap.channel),transmissionMapUv:ae&&m(x.transmissionMap.channel),thicknessMapUv:se&&m(x.thicknessMap.channel),alphaMapUv:ye&&m(x.alphaMap.channel),vertexTangents:!!E.attributes.tangent&&(Pt||ln),vertexNormals:!!E.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!E.attributes.color&&E.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!E.attributes.uv&&(Be||ye),fog:!!k,useFog:x.fog===!0,fogExp2:!!k&&k.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||E.attributes.normal===void 0&&Pt===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:de,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:E.attributes.position!==void 0,morphTargets:E.morphAttributes.position!==void 0,morphNormals:E.morphAttributes.normal!==void 0,morphColors:E.morphAttributes.color!==void 0,morphTargetsCount:te,morphTextureStride:le,numSunLights:y.sun.length,numDirLights:y.directional.length,numPointLights:y.point.length,numSpotLights:y.spot.length,numSpotLightMaps:y.spotLightMap.length,numRectAreaLights:y.rectArea.length,numHemiLights:y.hemi.length,numSunLightShadows:y.sunShadowMap.length,numDirLightShadows:y.directionalShadowMap.length,numPointLightShadows:y.pointShadowMap.length,numSpotLightShadows:y.spotShadowMap.length,numSpotLightShadowsWithMaps:y.numSpotLightShadowsWithMaps,numLightProbes:y.numLightProbes,numLightProbeGrids:U.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:n.shadowMap.enabled&&L.length>0,shadowMapType:n.shadowMap.type,toneMapping:fe,decodeVideoTexture:Be&&x.map.isVideoTexture===!0&&St.getTransfer(x.map.colorSpace)===Lt,decodeVideoTextureEmissive:bt&&x.emissiveMap.isVideoTexture===!0&&St.getTransfer(x.emissiveMap.colorSpace)===Lt,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===rs,flipSided:x.side===ti,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:et&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(et&&x.extensions.multiDraw===!0||Ye)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return tt.vertexUv1s=l.has(1),tt.vertexUv2s=l.has(2),tt.vertexUv3s=l.has(3),l.clear(),tt}function _(x){let y=[];if(x.shaderID?y.push(x.shaderID):(y.push(x.customVertexShaderID),y.push(x.customFragmentShaderID)),x.defines!==void 0)for(let L in x.defines)y.push(L),y.push(x.defines[L]);return x.isRawShaderMaterial===!1&&(f(y,x),p(y,x),y.push(n.outputColorSpace)),y.push(x.customProgramCacheKey),y.join()}function f(x,y){x.push(y.precision),x.push(y.outputColorSpace),x.push(y.envMapMode),x.push(y.envMapPMREM),x.push(y.envMapMaxLod),x.push(y.envMapSize),x.push(y.mapUv),x.push(y.alphaMapUv),x.push(y.lightMapUv),x.push(y.aoMapUv),x.push(y.bumpMapUv),x.push(y.normalMapUv),x.push(y.displacementMapUv),x.push(y.emissiveMapUv),x.push(y.metalnessMapUv),x.push(y.roughnessMapUv),x.push(y.anisotropyMapUv),x.push(y.clearcoatMapUv),x.push(y.clearcoatNormalMapUv),x.push(y.clearcoatRoughnessMapUv),x.push(y.diffuseRoughnessMapUv),x.push(y.iridescenceMapUv),x.push(y.iridescenceThicknessMapUv),x.push(y.sheenColorMapUv),x.push(y.sheenRoughnessMapUv),x.push(y.specularMapUv),x.push(y.specularColorMapUv),x.push(y.specularIntensityMapUv),x.push(y.transmissionMapUv),x.push(y.thicknessMapUv),x.push(y.combine),x.push(y.fogExp2),x.push(y.sizeAttenuation),x.push(y.morphTargetsCount),x.push(y.numSunLights),x.push(y.numDirLights),x.push(y.numPointLights),x.push(y.numSpotLights),x.push(y.numSpotLightMaps),x.push(y.numHemiLights),x.push(y.numRectAreaLights),x.push(y.numSunLightShadows),x.push(y.numDirLightShadows),x.push(y.numPointLightShadows),x.push(y.numSpotLightShadows),x.push(y.numSpotLightShadowsWithMaps),x.push(y.numLightProbes),x.push(y.numLightProbeGrids),x.push(y.shadowMapType),x.push(y.toneMapping),x.push(y.numClippingPlanes),x.push(y.numClipIntersection),x.push(y.depthPacking)}function p(x,y){o.disableAll(),y.instancing&&o.enable(0),y.instancingColor&&o.enable(1),y.instancingMorph&&o.enable(2),y.matcap&&o.enable(3),y.envMap&&o.enable(4),y.normalMapObjectSpace&&o.enable(5),y.normalMapTangentSpace&&o.enable(6),y.clearcoat&&o.enable(7),y.iridescence&&o.enable(8),y.alphaTest&&o.enable(9),y.vertexColors&&o.enable(10),y.vertexAlphas&&o.enable(11),y.vertexUv1s&&o.enable(12),y.vertexUv2s&&o.enable(13),y.vertexUv3s&&o.enable(14),y.vertexTangents&&o.enable(15),y.anisotropy&&o.enable(16),y.alphaHash&&o.enable(17),y.batching&&o.enable(18),y.dispersion&&o.enable(19),y.retroreflection&&o.enable(24),y.diffuseRoughness&&o.enable(25),y.batchingColor&&o.enable(20),y.gradientMap&&o.enable(21),y.packedNormalMap&&o.enable(22),y.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),y.fog&&o.enable(0),y.useFog&&o.enable(1),y.flatShading&&o.enable(2),y.logarithmicDepthBuffer&&o.enable(3),y.reversedDepthBuffer&&o.enable(4),y.skinning&&o.enable(5),y.morphTargets&&o.enable(6),y.morphNormals&&o.enable(7),y.morphColors&&o.enable(8),y.premultipliedAlpha&&o.enable(9),y.shadowMapEnabled&&o.enable(10),y.doubleSided&&o.enable(11),y.flipSided&&o.enable(12),y.useDepthPacking&&o.enable(13),y.dithering&&o.enable(14),y.transmission&&o.enable(15),y.sheen&&o.enable(16),y.opaque&&o.enable(17),y.pointsUvs&&o.enable(18),y.decodeVideoTexture&&o.enable(19),y.decodeVideoTextureEmissive&&o.enable(20),y.alphaToCoverage&&o.enable(21),y.numLightProbeGrids>0&&o.enable(22),y.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function v(x){let y=h[x.type],L;if(y){let R=ni[y];L=fl.clone(R.uniforms)}else L=x.uniforms;return L}function P(x,y){let L=u.get(y);return L!==void 0?++L.usedTimes:(L=new EE(n,y,x,s),c.push(L),u.set(y,L)),L}function b(x){if(--x.usedTimes===0){let y=c.indexOf(x);c[y]=c[c.length-1],c.pop(),u.delete(x.cacheKey),x.destroy()}}function C(x){a.remove(x)}function M(){a.dispose()}return{getParameters:g,getProgramCacheKey:_,getUniforms:v,acquireProgram:P,releaseProgram:b,releaseShaderCache:C,programs:c,dispose:M}}function CE(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function PE(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function b_(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function w_(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(h){let m=0;return h.isInstancedMesh&&(m+=2),h.isSkinnedMesh&&(m+=1),m}function a(h,m,g,_,f,p){let v=n[e];return v===void 0?(v={id:h.id,object:h,geometry:m,material:g,materialVariant:o(h),groupOrder:_,renderOrder:h.renderOrder,z:f,group:p},n[e]=v):(v.id=h.id,v.object=h,v.geometry=m,v.material=g,v.materialVariant=o(h),v.groupOrder=_,v.renderOrder=h.renderOrder,v.z=f,v.group=p),e++,v}function l(h,m,g,_,f,p,v){v.reversedDepth===!0&&(f=-f);let P=a(h,m,g,_,f,p);g.transmission>0?i.push(P):g.transparent===!0?s.push(P):t.push(P)}function c(h,m,g,_,f,p){let v=a(h,m,g,_,f,p);g.transmission>0?i.unshift(v):g.transparent===!0?s.unshift(v):t.unshift(v)}function u(h,m){t.length>1&&t.sort(h||PE),i.length>1&&i.sort(m||b_),s.length>1&&s.sort(m||b_)}function d(){for(let h=e,m=n.length;h<m;h++){let g=n[h];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:d,sort:u}}function IE(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new w_,n.set(i,[o])):s>=r.length?(o=new w_,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function LE(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new Y,color:new ht};break;case"SpotLight":t={position:new Y,direction:new Y,color:new ht,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new Y,color:new ht,distance:0,decay:0};break;case"HemisphereLight":t={direction:new Y,skyColor:new ht,groundColor:new ht};break;case"RectAreaLight":t={color:new ht,position:new Y,halfWidth:new Y,halfHeight:new Y};break}return n[e.id]=t,t}}}function DE(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var NE=0;function UE(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function FE(n){let e=new LE,t=DE(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new Y);let s=new Y,r=new Bt,o=new Bt;function a(c){let u=0,d=0,h=0;for(let U=0;U<9;U++)i.probe[U].set(0,0,0);let m=0,g=0,_=0,f=0,p=0,v=0,P=0,b=0,C=0,M=0,x=0,y=0,L=0,R=0;c.sort(UE);for(let U=0,k=c.length;U<k;U++){let E=c[U],N=E.color,z=E.intensity,O=E.distance,X=null;if(E.shadow&&E.shadow.map&&(E.shadow.map.texture.format===sr?X=E.shadow.map.texture:X=E.shadow.map.depthTexture||E.shadow.map.texture),E.isAmbientLight)u+=N.r*z,d+=N.g*z,h+=N.b*z;else if(E.isLightProbe){for(let H=0;H<9;H++)i.probe[H].addScaledVector(E.sh.coefficients[H],z);R++}else if(E.isSunLight){let H=e.get(E);if(H.color.copy(E.color).multiplyScalar(E.intensity),E.castShadow){let Z=E.shadow,te=t.get(E);te.shadowIntensity=Z.intensity,te.shadowBias=Z.bias,te.shadowNormalBias=Z.normalBias,te.shadowRadius=Z.radius,te.shadowMapSize.copy(Z.mapSize).multiply(Z.getFrameExtents()),i.sunShadow[g]=te,i.sunShadowMap[g]=X;let le=Z.getViewportCount();for(let he=0;he<le;he++)i.sunShadowMatrix[_+he]=Z.getMatrix(he),i.sunShadowCascade[_+he]=Z._cascadeData[he];_+=le,g++}i.sun[m]=H,m++}else if(E.isDirectionalLight){let H=e.get(E);if(H.color.copy(E.color).multiplyScalar(E.intensity),E.castShadow){let Z=E.shadow,te=t.get(E);te.shadowIntensity=Z.intensity,te.shadowBias=Z.bias,te.shadowNormalBias=Z.normalBias,te.shadowRadius=Z.radius,te.shadowMapSize=Z.mapSize,i.directionalShadow[f]=te,i.directionalShadowMap[f]=X,i.directionalShadowMatrix[f]=E.shadow.matrix,C++}i.directional[f]=H,f++}else if(E.isSpotLight){let H=e.get(E);H.position.setFromMatrixPosition(E.matrixWorld),H.color.copy(N).multiplyScalar(z),H.distance=O,H.coneCos=Math.cos(E.angle),H.penumbraCos=Math.cos(E.angle*(1-E.penumbra)),H.decay=E.decay,i.spot[v]=H;let Z=E.shadow;if(E.map&&(i.spotLightMap[y]=E.map,y++,Z.updateMatrices(E),E.castShadow&&L++),i.spotLightMatrix[v]=Z.matrix,E.castShadow){let te=t.get(E);te.shadowIntensity=Z.intensity,te.shadowBias=Z.bias,te.shadowNormalBias=Z.normalBias,te.shadowRadius=Z.radius,te.shadowMapSize=Z.mapSize,i.spotShadow[v]=te,i.spotShadowMap[v]=X,x++}v++}else if(E.isRectAreaLight){let H=e.get(E);H.color.copy(N).multiplyScalar(z),H.halfWidth.set(E.width*.5,0,0),H.halfHeight.set(0,E.height*.5,0),i.rectArea[P]=H,P++}else if(E.isPointLight){let H=e.get(E);if(H.color.copy(E.color).multiplyScalar(E.intensity),H.distance=E.distance,H.decay=E.decay,E.castShadow){let Z=E.shadow,te=t.get(E);te.shadowIntensity=Z.intensity,te.shadowBias=Z.bias,te.shadowNormalBias=Z.normalBias,te.shadowRadius=Z.radius,te.shadowMapSize=Z.mapSize,te.shadowCameraNear=Z.camera.near,te.shadowCameraFar=Z.camera.far,i.pointShadow[p]=te,i.pointShadowMap[p]=X,i.pointShadowMatrix[p]=E.shadow.matrix,M++}i.point[p]=H,p++}else if(E.isHemisphereLight){let H=e.get(E);H.skyColor.copy(E.color).multiplyScalar(z),H.groundColor.copy(E.groundColor).multiplyScalar(z),i.hemi[b]=H,b++}}P>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ie.LTC_FLOAT_1,i.rectAreaLTC2=Ie.LTC_FLOAT_2):(i.rectAreaLTC1=Ie.LTC_HALF_1,i.rectAreaLTC2=Ie.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=d,i.ambient[2]=h;let I=i.hash;(I.sunLength!==m||I.directionalLength!==f||I.pointLength!==p||I.spotLength!==v||I.rectAreaLength!==P||I.hemiLength!==b||I.numSunShadows!==g||I.numDirectionalShadows!==C||I.numPointShadows!==M||I.numSpotShadows!==x||I.numSpotMaps!==y||I.numLightProbes!==R)&&(i.sun.length=m,i.directional.length=f,i.spot.length=v,i.rectArea.length=P,i.point.length=p,i.hemi.length=b,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=_,i.sunShadowCascade.length=_,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=M,i.pointShadowMap.length=M,i.pointShadowMatrix.length=M,i.spotShadow.length=x,i.spotShadowMap.length=x,i.spotLightMatrix.length=x+y-L,i.spotLightMap.length=y,i.numSpotLightShadowsWithMaps=L,i.numLightProbes=R,I.sunLength=m,I.directionalLength=f,I.pointLength=p,I.spotLength=v,I.rectAreaLength=P,I.hemiLength=b,I.numSunShadows=g,I.numDirectionalShadows=C,I.numPointShadows=M,I.numSpotShadows=x,I.numSpotMaps=y,I.numLightProbes=R,i.version=NE++)}function l(c,u){let d=0,h=0,m=0,g=0,_=0,f=0,p=u.matrixWorldInverse;for(let v=0,P=c.length;v<P;v++){let b=c[v];if(b.isSunLight){let C=i.sun[d];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(p),d++}else if(b.isDirectionalLight){let C=i.directional[h];C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(p),h++}else if(b.isSpotLight){let C=i.spot[g];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(p),C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(p),g++}else if(b.isRectAreaLight){let C=i.rectArea[_];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(p),o.identity(),r.copy(b.matrixWorld),r.premultiply(p),o.extractRotation(r),C.halfWidth.set(b.width*.5,0,0),C.halfHeight.set(0,b.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),_++}else if(b.isPointLight){let C=i.point[m];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(p),m++}else if(b.isHemisphereLight){let C=i.hemi[f];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(p),f++}}}return{setup:a,setupView:l,state:i}}function E_(n){let e=new FE(n),t=[],i=[],s=[];function r(d){u.camera=d,t.length=0,i.length=0,s.length=0}function o(d){d.isLightProbeGrid?s.push(d):t.push(d)}function a(d){i.push(d)}function l(){e.setup(t),s.sort((d,h)=>d.priority-h.priority||d.id-h.id)}function c(d){e.setupView(t,d)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function OE(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new E_(n),e.set(s,[a])):r>=o.length?(a=new E_(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var BE=`void main() {
gl_Position = vec4( position, 1.0 );
}`,kE=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
const float samples = float( VSM_SAMPLES );
float mean = 0.0;
float squared_mean = 0.0;
float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
for ( float i = 0.0; i < samples; i ++ ) {
float uvOffset = uvStart + i * uvStride;
#ifdef HORIZONTAL_PASS
vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
mean += distribution.x;
squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
#else
float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
mean += depth;
squared_mean += depth * depth;
#endif
}
mean = mean / samples;
squared_mean = squared_mean / samples;
float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,zE=[new Y(1,0,0),new Y(-1,0,0),new Y(0,1,0),new Y(0,-1,0),new Y(0,0,1),new Y(0,0,-1)],VE=[new Y(0,-1,0),new Y(0,-1,0),new Y(0,0,1),new Y(0,0,-1),new Y(0,-1,0),new Y(0,-1,0)],T_=new Bt,pl=new Y,Bf=new Y;function GE(n,e,t){let i=new Zs,s=new Ke,r=new Ke,o=new Dt,a=new Yc,l=new $c,c={},u=t.maxTextureSize,d={[ir]:ti,[ti]:ir,[rs]:rs},h=new Ti({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ke},radius:{value:4}},vertexShader:BE,fragmentShader:kE}),m=h.clone();m.defines.HORIZONTAL_PASS=1;let g=new ii;g.setAttribute("position",new Bi(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new zn(g,h),f=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=sl;let p=this.type;this.render=function(M,x,y){if(f.enabled===!1||f.autoUpdate===!1&&f.needsUpdate===!1||M.length===0)return;this.type===b0&&(je("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=sl);let L=n.getRenderTarget(),R=n.getActiveCubeFace(),I=n.getActiveMipmapLevel(),U=n.state;U.setBlending(Dr),U.buffers.depth.getReversed()===!0?U.buffers.color.setClear(0,0,0,0):U.buffers.color.setClear(1,1,1,1),U.buffers.depth.setTest(!0),U.setScissorTest(!1);let k=p!==this.type;k&&x.traverse(function(E){E.material&&(Array.isArray(E.material)?E.material.forEach(N=>N.needsUpdate=!0):E.material.needsUpdate=!0)});for(let E=0,N=M.length;E<N;E++){let z=M[E],O=z.shadow;if(O===void 0){je("WebGLShadowMap:",z,"has no shadow.");continue}if(O.autoUpdate===!1&&O.needsUpdate===!1)continue;s.copy(O.mapSize);let X=O.getFrameExtents();s.multiply(X),r.copy(O.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/X.x),s.x=r.x*X.x,O.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/X.y),s.y=r.y*X.y,O.mapSize.y=r.y));let H=n.state.buffers.depth.getReversed();if(O.camera._reversedDepth=H,O.map===null||k===!0){if(O.map!==null&&(O.map.depthTexture!==null&&(O.map.depthTexture.dispose(),O.map.depthTexture=null),O.map.dispose()),this.type===Wo){if(z.isPointLight){je("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}O.map=new _i(s.x,s.y,{format:sr,type:Wi,minFilter:Kn,magFilter:Kn,generateMipmaps:!1}),O.map.texture.name=z.name+".shadowMap",O.map.depthTexture=new Rs(s.x,s.y,Hi),O.map.depthTexture.name=z.name+".shadowMapDepth",O.map.depthTexture.format=Ts,O.map.depthTexture.compareFunction=null,O.map.depthTexture.minFilter=_n,O.map.depthTexture.magFilter=_n}else z.isPointLight?(O.map=new gl(s.x),O.map.depthTexture=new Ga(s.x,Gi)):(O.map=new _i(s.x,s.y),O.map.depthTexture=new Rs(s.x,s.y,Gi)),O.map.depthTexture.name=z.name+".shadowMap",O.map.depthTexture.format=Ts,this.type===sl?(O.map.depthTexture.compareFunction=H?vf:yf,O.map.depthTexture.minFilter=Kn,O.map.depthTexture.magFilter=Kn):(O.map.depthTexture.compareFunction=null,O.map.depthTexture.minFilter=_n,O.map.depthTexture.magFilter=_n);O.camera.updateProjectionMatrix()}O.map.isWebGLCubeRenderTarget!==!0&&(O.map.width!==s.x||O.map.height!==s.y)&&O.map.setSize(s.x,s.y);let Z=O.map.isWebGLCubeRenderTarget?6:O.getViewportCount();z.isPointLight!==!0&&O.updateMatrices(z,y);let te=(O.camera.layers.mask&4294967294)!==0?O.camera.layers:y.layers;for(let le=0;le<Z;le++){let he=O.getCamera(le);if(z.isPointLight){let Q=O.camera,me=O.matrix,ge=z.distance||Q.far;ge!==Q.far&&(Q.far=ge,Q.updateProjectionMatrix()),pl.setFromMatrixPosition(z.matrixWorld),Q.position.copy(pl),Bf.copy(Q.position),Bf.add(zE[le]),Q.up.copy(VE[le]),Q.lookAt(Bf),Q.updateMatrixWorld(),me.makeTranslation(-pl.x,-pl.y,-pl.z),T_.multiplyMatrices(Q.projectionMatrix,Q.matrixWorldInverse),O._frustum.setFromProjectionMatrix(T_,Q.coordinateSystem,Q.reversedDepth)}if(O.map.isWebGLCubeRenderTarget)n.setRenderTarget(O.map,le),n.clear();else{le===0&&(n.setRenderTarget(O.map),n.clear());let Q=O.getViewport(le);o.set(r.x*Q.x,r.y*Q.y,r.x*Q.z,r.y*Q.w),U.viewport(o)}i=O.getFrustum(le),b(x,y,he,z,te,this.type)}O.isPointLightShadow!==!0&&this.type===Wo&&v(O,y),O.needsUpdate=!1}p=this.type,f.needsUpdate=!1,n.setRenderTarget(L,R,I)};function v(M,x){let y=e.update(_);h.defines.VSM_SAMPLES!==M.blurSamples&&(h.defines.VSM_SAMPLES=M.blurSamples,m.defines.VSM_SAMPLES=M.blurSamples,h.needsUpdate=!0,m.needsUpdate=!0),M.mapPass===null?M.mapPass=new _i(s.x,s.y,{format:sr,type:Wi}):(M.mapPass.width!==M.map.width||M.mapPass.height!==M.map.height)&&M.mapPass.setSize(M.map.width,M.map.height),h.uniforms.shadow_pass.value=M.map.depthTexture,h.uniforms.resolution.value.set(M.map.width,M.map.height),h.uniforms.radius.value=M.radius,n.setRenderTarget(M.mapPass),n.clear(),n.renderBufferDirect(x,null,y,h,_,null),m.uniforms.shadow_pass.value=M.mapPass.texture,m.uniforms.resolution.value.set(M.map.width,M.map.height),m.uniforms.radius.value=M.radius,n.setRenderTarget(M.map),n.clear(),n.renderBufferDirect(x,null,y,m,_,null)}function P(M,x,y,L){let R=null,I=y.isPointLight===!0?M.customDistanceMaterial:M.customDepthMaterial;if(I!==void 0)R=I;else if(R=y.isPointLight===!0?l:a,n.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let U=R.uuid,k=x.uuid,E=c[U];E===void 0&&(E={},c[U]=E);let N=E[k];N===void 0&&(N=R.clone(),E[k]=N,x.addEventListener("dispose",C)),R=N}if(R.visible=x.visible,R.wireframe=x.wireframe,L===Wo?R.side=x.shadowSide!==null?x.shadowSide:x.side:R.side=x.shadowSide!==null?x.shadowSide:d[x.side],R.alphaMap=x.alphaMap,R.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,R.map=x.map,R.clipShadows=x.clipShadows,R.clippingPlanes=x.clippingPlanes,R.clipIntersection=x.clipIntersection,R.displacementMap=x.displacementMap,R.displacementScale=x.displacementScale,R.displacementBias=x.displacementBias,R.wireframeLinewidth=x.wireframeLinewidth,R.linewidth=x.linewidth,y.isPointLight===!0&&R.isMeshDistanceMaterial===!0){let U=n.properties.get(R);U.light=y}return R}function b(M,x,y,L,R,I){if(M.visible===!1)return;if(M.layers.test(R)&&(M.isMesh||M.isLine||M.isPoints)&&(M.castShadow||M.receiveShadow&&I===Wo)&&(!M.frustumCulled||M.intersectsFrustum(i))){M.modelViewMatrix.multiplyMatrices(y.matrixWorldInverse,M.matrixWorld);let E=e.update(M),N=M.material;if(Array.isArray(N)){let z=E.groups;for(let O=0,X=z.length;O<X;O++){let H=z[O],Z=N[H.materialIndex];if(Z&&Z.visible){let te=P(M,Z,L,I);M.onBeforeShadow(n,M,x,y,E,te,H),n.renderBufferDirect(y,null,E,te,M,H),M.onAfterShadow(n,M,x,y,E,te,H)}}}else if(N.visible){let z=P(M,N,L,I);M.onBeforeShadow(n,M,x,y,E,z,null),n.renderBufferDirect(y,null,E,z,M,null),M.onAfterShadow(n,M,x,y,E,z,null)}}let k=M.children;for(let E=0,N=k.length;E<N;E++)b(k[E],x,y,L,R,I)}function C(M){M.target.removeEventListener("dispose",C);for(let y in c){let L=c[y],R=M.target.uuid;R in L&&(L[R].dispose(),delete L[R])}}}function HE(n,e){function t(){let V=!1,ae=new Dt,se=null,Te=new Dt(0,0,0,0);return{setMask:function(ye){se!==ye&&!V&&(n.colorMask(ye,ye,ye,ye),se=ye)},setLocked:function(ye){V=ye},setClear:function(ye,we,qe,et,fe){fe===!0&&(ye*=et,we*=et,qe*=et),ae.set(ye,we,qe,et),Te.equals(ae)===!1&&(n.clearColor(ye,we,qe,et),Te.copy(ae))},reset:function(){V=!1,se=null,Te.set(-1,0,0,0)}}}function i(){let V=!1,ae=!1,se=null,Te=null,ye=null;return{setReversed:function(we){if(ae!==we){let qe=e.get("EXT_clip_control");we?qe.clipControlEXT(qe.LOWER_LEFT_EXT,qe.ZERO_TO_ONE_EXT):qe.clipControlEXT(qe.LOWER_LEFT_EXT,qe.NEGATIVE_ONE_TO_ONE_EXT),ae=we;let et=ye;ye=null,this.setClear(et)}},getReversed:function(){return ae},setTest:function(we){we?de(n.DEPTH_TEST):Ne(n.DEPTH_TEST)},setMask:function(we){se!==we&&!V&&(n.depthMask(we),se=we)},setFunc:function(we){if(ae&&(we=n_[we]),Te!==we){switch(we){case Ec:n.depthFunc(n.NEVER);break;case Tc:n.depthFunc(n.ALWAYS);break;case Ac:n.depthFunc(n.LESS);break;case No:n.depthFunc(n.LEQUAL);break;case Rc:n.depthFunc(n.EQUAL);break;case Cc:n.depthFunc(n.GEQUAL);break;case Pc:n.depthFunc(n.GREATER);break;case Ic:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Te=we}},setLocked:function(we){V=we},setClear:function(we){ye!==we&&(ye=we,ae&&(we=1-we),n.clearDepth(we))},reset:function(){V=!1,se=null,Te=null,ye=null,ae=!1}}}function s(){let V=!1,ae=null,se=null,Te=null,ye=null,we=null,qe=null,et=null,fe=null;return{setTest:function(Ve){V||(Ve?de(n.STENCIL_TEST):Ne(n.STENCIL_TEST))},setMask:function(Ve){ae!==Ve&&!V&&(n.stencilMask(Ve),ae=Ve)},setFunc:function(Ve,tt,Ce){(se!==Ve||Te!==tt||ye!==Ce)&&(n.stencilFunc(Ve,tt,Ce),se=Ve,Te=tt,ye=Ce)},setOp:function(Ve,tt,Ce){(we!==Ve||qe!==tt||et!==Ce)&&(n.stencilOp(Ve,tt,Ce),we=Ve,qe=tt,et=Ce)},setLocked:function(Ve){V=Ve},setClear:function(Ve){fe!==Ve&&(n.clearStencil(Ve),fe=Ve)},reset:function(){V=!1,ae=null,se=null,Te=null,ye=null,we=null,qe=null,et=null,fe=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},d={},h={},m=new WeakMap,g=[],_=null,f=!1,p=null,v=null,P=null,b=null,C=null,M=null,x=null,y=new ht(0,0,0),L=0,R=!1,I=null,U=null,k=null,E=null,N=null,z=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),O=!1,X=0,H=n.getParameter(n.VERSION);H.indexOf("WebGL")!==-1?(X=parseFloat(/^WebGL (\d)/.exec(H)[1]),O=X>=1):H.indexOf("OpenGL ES")!==-1&&(X=parseFloat(/^OpenGL ES (\d)/.exec(H)[1]),O=X>=2);let Z=null,te={},le=n.getParameter(n.SCISSOR_BOX),he=n.getParameter(n.VIEWPORT),Q=new Dt().fromArray(le),me=new Dt().fromArray(he);function ge(V,ae,se,Te){let ye=new Uint8Array(4),we=n.createTexture();n.bindTexture(V,we),n.texParameteri(V,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(V,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let qe=0;qe<se;qe++)V===n.TEXTURE_3D||V===n.TEXTURE_2D_ARRAY?n.texImage3D(ae,0,n.RGBA,1,1,Te,0,n.RGBA,n.UNSIGNED_BYTE,ye):n.texImage2D(ae+qe,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ye);return we}let oe={};oe[n.TEXTURE_2D]=ge(n.TEXTURE_2D,n.TEXTURE_2D,1),oe[n.TEXTURE_CUBE_MAP]=ge(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),oe[n.TEXTURE_2D_ARRAY]=ge(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),oe[n.TEXTURE_3D]=ge(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),de(n.DEPTH_TEST),o.setFunc(No),jt(!1),Pt(jd),de(n.CULL_FACE),pt(Dr);function de(V){u[V]!==!0&&(n.enable(V),u[V]=!0)}function Ne(V){u[V]!==!1&&(n.disable(V),u[V]=!1)}function Ye(V,ae){return h[V]!==ae?(n.bindFramebuffer(V,ae),h[V]=ae,V===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=ae),V===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=ae),!0):!1}function Be(V,ae){let se=g,Te=!1;if(V){se=m.get(ae),se===void 0&&(se=[],m.set(ae,se));let ye=V.textures;if(se.length!==ye.length||se[0]!==n.COLOR_ATTACHMENT0){for(let we=0,qe=ye.length;we<qe;we++)se[we]=n.COLOR_ATTACHMENT0+we;se.length=ye.length,Te=!0}}else se[0]!==n.BACK&&(se[0]=n.BACK,Te=!0);Te&&n.drawBuffers(se)}function st(V){return _!==V?(n.useProgram(V),_=V,!0):!1}let at={[Nr]:n.FUNC_ADD,[E0]:n.FUNC_SUBTRACT,[T0]:n.FUNC_REVERSE_SUBTRACT};at[A0]=n.MIN,at[R0]=n.MAX;let $e={[C0]:n.ZERO,[P0]:n.ONE,[I0]:n.SRC_COLOR,[ef]:n.SRC_ALPHA,[O0]:n.SRC_ALPHA_SATURATE,[U0]:n.DST_COLOR,[D0]:n.DST_ALPHA,[L0]:n.ONE_MINUS_SRC_COLOR,[tf]:n.ONE_MINUS_SRC_ALPHA,[F0]:n.ONE_MINUS_DST_COLOR,[N0]:n.ONE_MINUS_DST_ALPHA,[B0]:n.CONSTANT_COLOR,[k0]:n.ONE_MINUS_CONSTANT_COLOR,[z0]:n.CONSTANT_ALPHA,[V0]:n.ONE_MINUS_CONSTANT_ALPHA};function pt(V,ae,se,Te,ye,we,qe,et,fe,Ve){if(V===Dr){f===!0&&(Ne(n.BLEND),f=!1);return}if(f===!1&&(de(n.BLEND),f=!0),V!==w0){if(V!==p||Ve!==R){if((v!==Nr||C!==Nr)&&(n.blendEquation(n.FUNC_ADD),v=Nr,C=Nr),Ve)switch(V){case qo:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Jd:n.blendFunc(n.ONE,n.ONE);break;case Kd:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Qd:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:it("WebGLState: Invalid blending: ",V);break}else switch(V){case qo:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Jd:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Kd:it("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Qd:it("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:it("WebGLState: Invalid blending: ",V);break}P=null,b=null,M=null,x=null,y.set(0,0,0),L=0,p=V,R=Ve}return}ye=ye||ae,we=we||se,qe=qe||Te,(ae!==v||ye!==C)&&(n.blendEquationSeparate(at[ae],at[ye]),v=ae,C=ye),(se!==P||Te!==b||we!==M||qe!==x)&&(n.blendFuncSeparate($e[se],$e[Te],$e[we],$e[qe]),P=se,b=Te,M=we,x=qe),(et.equals(y)===!1||fe!==L)&&(n.blendColor(et.r,et.g,et.b,fe),y.copy(et),L=fe),p=V,R=!1}function Mt(V,ae){V.side===rs?Ne(n.CULL_FACE):de(n.CULL_FACE);let se=V.side===ti;ae&&(se=!se),jt(se),V.blending===qo&&V.transparent===!1?pt(Dr):pt(V.blending,V.blendEquation,V.blendSrc,V.blendDst,V.blendEquationAlpha,V.blendSrcAlpha,V.blendDstAlpha,V.blendColor,V.blendAlpha,V.premultipliedAlpha),o.setFunc(V.depthFunc),o.setTest(V.depthTest),o.setMask(V.depthWrite),r.setMask(V.colorWrite);let Te=V.stencilWrite;a.setTest(Te),Te&&(a.setMask(V.stencilWriteMask),a.setFunc(V.stencilFunc,V.stencilRef,V.stencilFuncMask),a.setOp(V.stencilFail,V.stencilZFail,V.stencilZPass)),bt(V.polygonOffset,V.polygonOffsetFactor,V.polygonOffsetUnits),V.alphaToCoverage===!0?de(n.SAMPLE_ALPHA_TO_COVERAGE):Ne(n.SAMPLE_ALPHA_TO_COVERAGE)}function jt(V){I!==V&&(V?n.frontFace(n.CW):n.frontFace(n.CCW),I=V)}function Pt(V){V!==S0?(de(n.CULL_FACE),V!==U&&(V===jd?n.cullFace(n.BACK):V===M0?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ne(n.CULL_FACE),U=V}function rn(V){V!==k&&(O&&n.lineWidth(V),k=V)}function bt(V,ae,se){V?(de(n.POLYGON_OFFSET_FILL),(E!==ae||N!==se)&&(E=ae,N=se,o.getReversed()&&(ae=-ae,se=-se),n.polygonOffset(ae,se))):Ne(n.POLYGON_OFFSET_FILL)}function xn(V){V?de(n.SCISSOR_TEST):Ne(n.SCISSOR_TEST)}function Qt(V){V===void 0&&(V=n.TEXTURE0+z-1),Z!==V&&(n.activeTexture(V),Z=V)}function ln(V,ae,se){se===void 0&&(Z===null?se=n.TEXTURE0+z-1:se=Z);let Te=te[se];Te===void 0&&(Te={type:void 0,texture:void 0},te[se]=Te),(Te.type!==V||Te.texture!==ae)&&(Z!==se&&(n.activeTexture(se),Z=se),n.bindTexture(V,ae||oe[V]),Te.type=V,Te.texture=ae)}function G(){let V=te[Z];V!==void 0&&V.type!==void 0&&(n.bindTexture(V.type,null),V.type=void 0,V.texture=void 0)}function Pe(){try{n.compressedTexImage2D(...arguments)}catch(V){it("WebGLState:",V)}}function Je(){try{n.compressedTexImage3D(...arguments)}catch(V){it("WebGLState:",V)}}function lt(){try{n.texSubImage2D(...arguments)}catch(V){it("WebGLState:",V)}}function Ee(){try{n.texSubImage3D(...arguments)}catch(V){it("WebGLState:",V)}}function zt(){try{n.compressedTexSubImage2D(...arguments)}catch(V){it("WebGLState:",V)}}function We(){try{n.compressedTexSubImage3D(...arguments)}catch(V){it("WebGLState:",V)}}function Ze(){try{n.texStorage2D(...arguments)}catch(V){it("WebGLState:",V)}}function D(){try{n.texStorage3D(...arguments)}catch(V){it("WebGLState:",V)}}function w(){try{n.texImage2D(...arguments)}catch(V){it("WebGLState:",V)}}function j(){try{n.texImage3D(...arguments)}catch(V){it("WebGLState:",V)}}function pe(V){return d[V]!==void 0?d[V]:n.getParameter(V)}function ce(V,ae){d[V]!==ae&&(n.pixelStorei(V,ae),d[V]=ae)}function ve(V){Q.equals(V)===!1&&(n.scissor(V.x,V.y,V.z,V.w),Q.copy(V))}function Se(V){me.equals(V)===!1&&(n.viewport(V.x,V.y,V.z,V.w),me.copy(V))}function ie(V,ae){let se=c.get(ae);se===void 0&&(se=new WeakMap,c.set(ae,se));let Te=se.get(V);Te===void 0&&(Te=n.getUniformBlockIndex(ae,V.name),n.uniformBlockBinding(ae,Te,Te),se.set(V,Te))}function re(V,ae,se){let ye=c.get(ae).get(V);l[ye]!==se&&(n.bindBufferBase(n.UNIFORM_BUFFER,ye,se),l[ye]=se)}function xe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},d={},Z=null,te={},h={},l={},m=new WeakMap,g=[],_=null,f=!1,p=null,v=null,P=null,b=null,C=null,M=null,x=null,y=new ht(0,0,0),L=0,R=!1,I=null,U=null,k=null,E=null,N=null,Q.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:de,disable:Ne,bindFramebuffer:Ye,drawBuffers:Be,useProgram:st,setBlending:pt,setMaterial:Mt,setFlipSided:jt,setCullFace:Pt,setLineWidth:rn,setPolygonOffset:bt,setScissorTest:xn,activeTexture:Qt,bindTexture:ln,unbindTexture:G,compressedTexImage2D:Pe,compressedTexImage3D:Je,texImage2D:w,texImage3D:j,pixelStorei:ce,getParameter:pe,updateUBOMapping:ie,uniformBlockBinding:re,texStorage2D:Ze,texStorage3D:D,texSubImage2D:lt,texSubImage3D:Ee,compressedTexSubImage2D:zt,compressedTexSubImage3D:We,scissor:ve,viewport:Se,reset:xe}}function WE(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ke,u=new WeakMap,d=new Set,h,m=new WeakMap,g=new Set,_=new FinalizationRegistry(D=>g.delete(D)),f=!1;try{f=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(D,w){return f?new OffscreenCanvas(D,w):La("canvas")}function v(D,w,j){let pe=1,ce=Ze(D);if((ce.width>j||ce.height>j)&&(pe=j/Math.max(ce.width,ce.height)),pe<1)if(typeof HTMLImageElement<"u"&&D instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&D instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&D instanceof ImageBitmap||typeof VideoFrame<"u"&&D instanceof VideoFrame){let ve=Math.floor(pe*ce.width),Se=Math.floor(pe*ce.height);h===void 0&&(h=p(ve,Se));let ie=w?p(ve,Se):h;return ie.width=ve,ie.height=Se,ie.getContext("2d").drawImage(D,0,0,ve,Se),je("WebGLRenderer: Texture has been resized from ("+ce.width+"x"+ce.height+") to ("+ve+"x"+Se+")."),ie}else return"data"in D&&je("WebGLRenderer: Image in DataTexture is too big ("+ce.width+"x"+ce.height+")."),D;return D}function P(D){return D.generateMipmaps}function b(D){n.generateMipmap(D)}function C(D){return D.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:D.isWebGL3DRenderTarget?n.TEXTURE_3D:D.isWebGLArrayRenderTarget||D.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function M(D,w,j,pe,ce,ve=!1){if(D!==null){if(n[D]!==void 0)return n[D];je("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+D+"'")}let Se;pe&&(Se=e.get("EXT_texture_norm16"),Se||je("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ie=w;if(w===n.RED&&(j===n.FLOAT&&(ie=n.R32F),j===n.HALF_FLOAT&&(ie=n.R16F),j===n.UNSIGNED_BYTE&&(ie=n.R8),j===n.UNSIGNED_SHORT&&Se&&(ie=Se.R16_EXT),j===n.SHORT&&Se&&(ie=Se.R16_SNORM_EXT)),w===n.RED_INTEGER&&(j===n.UNSIGNED_BYTE&&(ie=n.R8UI),j===n.UNSIGNED_SHORT&&(ie=n.R16UI),j===n.UNSIGNED_INT&&(ie=n.R32UI),j===n.BYTE&&(ie=n.R8I),j===n.SHORT&&(ie=n.R16I),j===n.INT&&(ie=n.R32I)),w===n.RG&&(j===n.FLOAT&&(ie=n.RG32F),j===n.HALF_FLOAT&&(ie=n.RG16F),j===n.UNSIGNED_BYTE&&(ie=n.RG8),j===n.UNSIGNED_SHORT&&Se&&(ie=Se.RG16_EXT),j===n.SHORT&&Se&&(ie=Se.RG16_SNORM_EXT)),w===n.RG_INTEGER&&(j===n.UNSIGNED_BYTE&&(ie=n.RG8UI),j===n.UNSIGNED_SHORT&&(ie=n.RG16UI),j===n.UNSIGNED_INT&&(ie=n.RG32UI),j===n.BYTE&&(ie=n.RG8I),j===n.SHORT&&(ie=n.RG16I),j===n.INT&&(ie=n.RG32I)),w===n.RGB_INTEGER&&(j===n.UNSIGNED_BYTE&&(ie=n.RGB8UI),j===n.UNSIGNED_SHORT&&(ie=n.RGB16UI),j===n.UNSIGNED_INT&&(ie=n.RGB32UI),j===n.BYTE&&(ie=n.RGB8I),j===n.SHORT&&(ie=n.RGB16I),j===n.INT&&(ie=n.RGB32I)),w===n.RGBA_INTEGER&&(j===n.UNSIGNED_BYTE&&(ie=n.RGBA8UI),j===n.UNSIGNED_SHORT&&(ie=n.RGBA16UI),j===n.UNSIGNED_INT&&(ie=n.RGBA32UI),j===n.BYTE&&(ie=n.RGBA8I),j===n.SHORT&&(ie=n.RGBA16I),j===n.INT&&(ie=n.RGBA32I)),w===n.RGB&&(j===n.UNSIGNED_SHORT&&Se&&(ie=Se.RGB16_EXT),j===n.SHORT&&Se&&(ie=Se.RGB16_SNORM_EXT),j===n.UNSIGNED_INT_5_9_9_9_REV&&(ie=n.RGB9_E5),j===n.UNSIGNED_INT_10F_11F_11F_REV&&(ie=n.R11F_G11F_B10F)),w===n.RGBA){let re=ve?Ia:St.getTransfer(ce);j===n.FLOAT&&(ie=n.RGBA32F),j===n.HALF_FLOAT&&(ie=n.RGBA16F),j===n.UNSIGNED_BYTE&&(ie=re===Lt?n.SRGB8_ALPHA8:n.RGBA8),j===n.UNSIGNED_SHORT&&Se&&(ie=Se.RGBA16_EXT),j===n.SHORT&&Se&&(ie=Se.RGBA16_SNORM_EXT),j===n.UNSIGNED_SHORT_4_4_4_4&&(ie=n.RGBA4),j===n.UNSIGNED_SHORT_5_5_5_1&&(ie=n.RGB5_A1)}return(ie===n.R16F||ie===n.R32F||ie===n.RG16F||ie===n.RG32F||ie===n.RGBA16F||ie===n.RGBA32F)&&e.get("EXT_color_buffer_float"),ie}function x(D,w){let j;return D?w===null||w===Gi||w===Fr?j=n.DEPTH24_STENCIL8:w===Hi?j=n.DEPTH32F_STENCIL8:w===Yo&&(j=n.DEPTH24_STENCIL8,je("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===Gi||w===Fr?j=n.DEPTH_COMPONENT24:w===Hi?j=n.DEPTH_COMPONENT32F:w===Yo&&(j=n.DEPTH_COMPONENT16),j}function y(D,w){return P(D)===!0||D.isFramebufferTexture&&D.minFilter!==_n&&D.minFilter!==Kn?Math.log2(Math.max(w.width,w.height))+1:D.mipmaps.length>0?D.mipmaps.length:D.isCompressedTexture&&Array.isArray(D.image)?w.mipmaps.length:1}function L(D){let w=new WeakRef(D);i.get(D).__ref=w,g.add(w),_.register(D,w,w)}function R(D){let w=i.get(D).__ref;w!==void 0&&(g.delete(w),_.unregister(w))}function I(D){k(D.target)}function U(D){E(D.target)}function k(D){D.removeEventListener("dispose",I),R(D),z(D),D.isVideoTexture&&u.delete(D),D.isHTMLTexture&&d.delete(D)}function E(D){D.removeEventListener("dispose",U),R(D),X(D)}function N(){for(let D of g){let w=D.deref();w!==void 0&&(w.isRenderTarget===!0?E(w):k(w))}g.clear(),d.clear()}function z(D){let w=i.get(D);if(w.__webglInit===void 0)return;let j=D.source,pe=m.get(j);if(pe){let ce=pe[w.__cacheKey];ce.usedTimes--,ce.usedTimes===0&&O(D),Object.keys(pe).length===0&&m.delete(j)}i.remove(D)}function O(D){let w=i.get(D);n.deleteTexture(w.__webglTexture);let j=D.source,pe=m.get(j);delete pe[w.__cacheKey],o.memory.textures--}function X(D){let w=i.get(D);w.__depthDisposeCallback&&w.__depthDisposeCallback();let j=D.depthTexture;if(j&&j.renderTarget===D&&k(j),D.isWebGLCubeRenderTarget)for(let ce=0;ce<6;ce++){if(Array.isArray(w.__webglFramebuffer[ce]))for(let ve=0;ve<w.__webglFramebuffer[ce].length;ve++)n.deleteFramebuffer(w.__webglFramebuffer[ce][ve]);else n.deleteFramebuffer(w.__webglFramebuffer[ce]);w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer[ce])}else{if(Array.isArray(w.__webglFramebuffer))for(let ce=0;ce<w.__webglFramebuffer.length;ce++)n.deleteFramebuffer(w.__webglFramebuffer[ce]);else n.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&n.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let ce=0;ce<w.__webglColorRenderbuffer.length;ce++)w.__webglColorRenderbuffer[ce]&&n.deleteRenderbuffer(w.__webglColorRenderbuffer[ce]);w.__webglDepthRenderbuffer&&n.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let pe=D.textures;for(let ce=0,ve=pe.length;ce<ve;ce++){let Se=i.get(pe[ce]);Se.__webglTexture&&(n.deleteTexture(Se.__webglTexture),o.memory.textures--),i.remove(pe[ce])}i.remove(D)}let H=0;function Z(){H=0}function te(){return H}function le(D){H=D}function he(){let D=H;return D>=s.maxTextures&&je("WebGLTextures: Trying to use "+(D+1)+" texture units while this GPU supports only "+s.maxTextures),H+=1,D}function Q(D){let w=[];return w.push(D.wrapS),w.push(D.wrapT),w.push(D.wrapR||0),w.push(D.magFilter),w.push(D.minFilter),w.push(D.anisotropy),w.push(D.internalFormat),w.push(D.format),w.push(D.type),w.push(D.generateMipmaps),w.push(D.mipmapsAutoUpdate),w.push(D.premultiplyAlpha),w.push(D.flipY),w.push(D.unpackAlignment),w.push(D.colorSpace),w.join()}function me(D,w){let j=i.get(D);if(D.isVideoTexture&&zt(D),D.isRenderTargetTexture===!1&&D.isExternalTexture!==!0&&D.version>0&&j.__version!==D.version){let pe=D.image;if(pe===null)je("WebGLRenderer: Texture marked for update but no image data found.");else if(pe.complete===!1)je("WebGLRenderer: Texture marked for update but image is incomplete");else{Mt(j,D,w);return}}else D.isExternalTexture&&(j.__webglTexture=D.sourceTexture?D.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,j.__webglTexture,n.TEXTURE0+w)}function ge(D,w){let j=i.get(D);if(D.isRenderTargetTexture===!1&&D.version>0&&j.__version!==D.version){Mt(j,D,w);return}else D.isExternalTexture&&(j.__webglTexture=D.sourceTexture?D.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,j.__webglTexture,n.TEXTURE0+w)}function oe(D,w){let j=i.get(D);if(D.isRenderTargetTexture===!1&&D.version>0&&j.__version!==D.version){Mt(j,D,w);return}t.bindTexture(n.TEXTURE_3D,j.__webglTexture,n.TEXTURE0+w)}function de(D,w){let j=i.get(D);if(D.version>0&&j.__version!==D.version){jt(j,D,w);return}t.bindTexture(n.TEXTURE_CUBE_MAP,j.__webglTexture,n.TEXTURE0+w)}let Ne={[Lc]:n.REPEAT,[is]:n.CLAMP_TO_EDGE,[Dc]:n.MIRRORED_REPEAT},Ye={[_n]:n.NEAREST,[W0]:n.NEAREST_MIPMAP_NEAREST,[rl]:n.NEAREST_MIPMAP_LINEAR,[Kn]:n.LINEAR,[hh]:n.LINEAR_MIPMAP_NEAREST,[Cs]:n.LINEAR_MIPMAP_LINEAR},Be={[$0]:n.NEVER,[Sf]:n.ALWAYS,[Z0]:n.LESS,[yf]:n.LEQUAL,[j0]:n.EQUAL,[vf]:n.GEQUAL,[J0]:n.GREATER,[K0]:n.NOTEQUAL};function st(D,w){if(w.type===Hi&&e.has("OES_texture_float_linear")===!1&&(w.magFilter===Kn||w.magFilter===hh||w.magFilter===rl||w.magFilter===Cs||w.minFilter===Kn||w.minFilter===hh||w.minFilter===rl||w.minFilter===Cs)&&je("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(D,n.TEXTURE_WRAP_S,Ne[w.wrapS]),n.texParameteri(D,n.TEXTURE_WRAP_T,Ne[w.wrapT]),(D===n.TEXTURE_3D||D===n.TEXTURE_2D_ARRAY)&&n.texParameteri(D,n.TEXTURE_WRAP_R,Ne[w.wrapR]),n.texParameteri(D,n.TEXTURE_MAG_FILTER,Ye[w.magFilter]),n.texParameteri(D,n.TEXTURE_MIN_FILTER,Ye[w.minFilter]),w.compareFunction&&(n.texParameteri(D,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(D,n.TEXTURE_COMPARE_FUNC,Be[w.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===_n||w.minFilter!==rl&&w.minFilter!==Cs||w.type===Hi&&e.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||i.get(w).__currentAnisotropy){let j=e.get("EXT_texture_filter_anisotropic");n.texParameterf(D,j.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),i.get(w).__currentAnisotropy=w.anisotropy}}}function at(D,w){let j=!1;D.__webglInit===void 0&&(D.__webglInit=!0,w.addEventListener("dispose",I),L(w));let pe=w.source,ce=m.get(pe);ce===void 0&&(ce={},m.set(pe,ce));let ve=Q(w);if(ve!==D.__cacheKey){ce[ve]===void 0&&(ce[ve]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,j=!0),ce[ve].usedTimes++;let Se=ce[D.__cacheKey];Se!==void 0&&(ce[D.__cacheKey].usedTimes--,Se.usedTimes===0&&O(w)),D.__cacheKey=ve,D.__webglTexture=ce[ve].texture}return j}function $e(D,w,j){return Math.floor(Math.floor(D/j)/w)}function pt(D,w,j,pe){let ve=D.updateRanges;if(ve.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,w.width,w.height,j,pe,w.data);else{ve.sort((V,ae)=>V.start-ae.start);let Se=0;for(let V=1;V<ve.length;V++){let ae=ve[Se],se=ve[V],Te=ae.start+ae.count,ye=$e(se.start,w.width,4),we=$e(ae.start,w.width,4);se.start<=Te+1&&ye===we&&$e(se.start+se.count-1,w.width,4)===ye?ae.count=Math.max(ae.count,se.start+se.count-ae.start):(++Se,ve[Se]=se)}ve.length=Se+1;let ie=t.getParameter(n.UNPACK_ROW_LENGTH),re=t.getParameter(n.UNPACK_SKIP_PIXELS),xe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,w.width);for(let V=0,ae=ve.length;V<ae;V++){let se=ve[V],Te=Math.floor(se.start/4),ye=Math.ceil(se.count/4),we=Te%w.width,qe=Math.floor(Te/w.width),et=ye,fe=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,we),t.pixelStorei(n.UNPACK_SKIP_ROWS,qe),t.texSubImage2D(n.TEXTURE_2D,0,we,qe,et,fe,j,pe,w.data)}D.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,ie),t.pixelStorei(n.UNPACK_SKIP_PIXELS,re),t.pixelStorei(n.UNPACK_SKIP_ROWS,xe)}}function Mt(D,w,j){let pe=n.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(pe=n.TEXTURE_2D_ARRAY),w.isData3DTexture&&(pe=n.TEXTURE_3D);let ce=at(D,w),ve=w.source;t.bindTexture(pe,D.__webglTexture,n.TEXTURE0+j);let Se=i.get(ve);if(ve.version!==Se.__version||ce===!0){if(t.activeTexture(n.TEXTURE0+j),(typeof ImageBitmap<"u"&&w.image instanceof ImageBitmap)===!1){let fe=St.getPrimaries(St.workingColorSpace),Ve=w.colorSpace===Is?null:St.getPrimaries(w.colorSpace),tt=w.colorSpace===Is||fe===Ve?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,tt)}t.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment);let re=v(w.image,!1,s.maxTextureSize);re=We(w,re);let xe=r.convert(w.format,w.colorSpace),V=r.convert(w.type),ae=M(w.internalFormat,xe,V,w.normalized,w.colorSpace,w.isVideoTexture);st(pe,w);let se,Te=w.mipmaps,ye=w.isVideoTexture!==!0,we=Se.__version===void 0||ce===!0,qe=ve.dataReady,et=y(w,re);if(w.isDepthTexture)ae=x(w.format===Ps,w.type),we&&(ye?t.texStorage2D(n.TEXTURE_2D,1,ae,re.width,re.height):t.texImage2D(n.TEXTURE_2D,0,ae,re.width,re.height,0,xe,V,null));else if(w.isDataTexture)if(Te.length>0){ye&&we&&t.texStorage2D(n.TEXTURE_2D,et,ae,Te[0].width,Te[0].height);for(let fe=0,Ve=Te.length;fe<Ve;fe++)se=Te[fe],ye?qe&&t.texSubImage2D(n.TEXTURE_2D,fe,0,0,se.width,se.height,xe,V,se.data):t.texImage2D(n.TEXTURE_2D,fe,ae,se.width,se.height,0,xe,V,se.data);w.generateMipmaps=!1}else ye?(we&&t.texStorage2D(n.TEXTURE_2D,et,ae,re.width,re.height),qe&&pt(w,re,xe,V)):t.texImage2D(n.TEXTURE_2D,0,ae,re.width,re.height,0,xe,V,re.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){ye&&we&&t.texStorage3D(n.TEXTURE_2D_ARRAY,et,ae,Te[0].width,Te[0].height,re.depth);for(let fe=0,Ve=Te.length;fe<Ve;fe++)if(se=Te[fe],w.format!==qi)if(xe!==null)if(ye){if(qe)if(w.layerUpdates.size>0){let tt=If(se.width,se.height,w.format,w.type);for(let Ce of w.layerUpdates){let ut=se.data.subarray(Ce*tt/se.data.BYTES_PER_ELEMENT,(Ce+1)*tt/se.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,fe,0,0,Ce,se.width,se.height,1,xe,ut)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,fe,0,0,0,se.width,se.height,re.depth,xe,se.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,fe,ae,se.width,se.height,re.depth,0,se.data,0,0);else je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ye?qe&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,fe,0,0,0,se.width,se.height,re.depth,xe,V,se.data):t.texImage3D(n.TEXTURE_2D_ARRAY,fe,ae,se.width,se.height,re.depth,0,xe,V,se.data);w.layerUpdates.size>0&&w.clearLayerUpdates()}else{ye&&we&&t.texStorage2D(n.TEXTURE_2D,et,ae,Te[0].width,Te[0].height);for(let fe=0,Ve=Te.length;fe<Ve;fe++)se=Te[fe],w.format!==qi?xe!==null?ye?qe&&t.compressedTexSubImage2D(n.TEXTURE_2D,fe,0,0,se.width,se.height,xe,se.data):t.compressedTexImage2D(n.TEXTURE_2D,fe,ae,se.width,se.height,0,se.data):je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ye?qe&&t.texSubImage2D(n.TEXTURE_2D,fe,0,0,se.width,se.height,xe,V,se.data):t.texImage2D(n.TEXTURE_2D,fe,ae,se.width,se.height,0,xe,V,se.data)}else if(w.isDataArrayTexture)if(ye){if(we&&t.texStorage3D(n.TEXTURE_2D_ARRAY,et,ae,re.width,re.height,re.depth),qe)if(w.layerUpdates.size>0){let fe=If(re.width,re.height,w.format,w.type);for(let Ve of w.layerUpdates){let tt=re.data.subarray(Ve*fe/re.data.BYTES_PER_ELEMENT,(Ve+1)*fe/re.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Ve,re.width,re.height,1,xe,V,tt)}w.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,re.width,re.height,re.depth,xe,V,re.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,ae,re.width,re.height,re.depth,0,xe,V,re.data);else if(w.isData3DTexture)ye?(we&&t.texStorage3D(n.TEXTURE_3D,et,ae,re.width,re.height,re.depth),qe&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,re.width,re.height,re.depth,xe,V,re.data)):t.texImage3D(n.TEXTURE_3D,0,ae,re.width,re.height,re.depth,0,xe,V,re.data);else if(w.isFramebufferTexture){if(we)if(ye)t.texStorage2D(n.TEXTURE_2D,et,ae,re.width,re.height);else{let fe=re.width,Ve=re.height;for(let tt=0;tt<et;tt++)t.texImage2D(n.TEXTURE_2D,tt,ae,fe,Ve,0,xe,V,null),fe>>=1,Ve>>=1}}else if(w.isHTMLTexture){if("texElementImage2D"in n){let fe=n.canvas;if(fe.hasAttribute("layoutsubtree")||fe.setAttribute("layoutsubtree","true"),re.parentNode!==fe){fe.appendChild(re),d.add(w),fe.onpaint=Ve=>{let tt=Ve.changedElements;for(let Ce of d)tt.includes(Ce.image)&&(Ce.needsUpdate=!0)},fe.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,re);else{let tt=n.RGBA,Ce=n.RGBA,ut=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,tt,Ce,ut,re)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Te.length>0){if(ye&&we){let fe=Ze(Te[0]);t.texStorage2D(n.TEXTURE_2D,et,ae,fe.width,fe.height)}for(let fe=0,Ve=Te.length;fe<Ve;fe++)se=Te[fe],ye?qe&&t.texSubImage2D(n.TEXTURE_2D,fe,0,0,xe,V,se):t.texImage2D(n.TEXTURE_2D,fe,ae,xe,V,se);w.generateMipmaps=!1}else if(ye){if(we){let fe=Ze(re);t.texStorage2D(n.TEXTURE_2D,et,ae,fe.width,fe.height)}qe&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,xe,V,re)}else t.texImage2D(n.TEXTURE_2D,0,ae,xe,V,re);P(w)&&w.mipmapsAutoUpdate===!0&&b(pe),Se.__version=ve.version,w.onUpdate&&w.onUpdate(w)}D.__version=w.version}function jt(D,w,j){if(w.image.length!==6)return;let pe=at(D,w),ce=w.source;t.bindTexture(n.TEXTURE_CUBE_MAP,D.__webglTexture,n.TEXTURE0+j);let ve=i.get(ce);if(ce.version!==ve.__version||pe===!0){t.activeTexture(n.TEXTURE0+j);let Se=St.getPrimaries(St.workingColorSpace),ie=w.colorSpace===Is?null:St.getPrimaries(w.colorSpace),re=w.colorSpace===Is||Se===ie?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,re);let xe=w.isCompressedTexture||w.image[0].isCompressedTexture,V=w.image[0]&&w.image[0].isDataTexture,ae=[];for(let Ce=0;Ce<6;Ce++)!xe&&!V?ae[Ce]=v(w.image[Ce],!0,s.maxCubemapSize):ae[Ce]=V?w.image[Ce].image:w.image[Ce],ae[Ce]=We(w,ae[Ce]);let se=ae[0],Te=r.convert(w.format,w.colorSpace),ye=r.convert(w.type),we=M(w.internalFormat,Te,ye,w.normalized,w.colorSpace),qe=w.isVideoTexture!==!0,et=ve.__version===void 0||pe===!0,fe=ce.dataReady,Ve=y(w,se);st(n.TEXTURE_CUBE_MAP,w);let tt;if(w.isDepthTexture){if(we=x(w.format===Ps,w.type),et)if(qe)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,we,se.width,se.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,we,se.width,se.height,0,Te,ye,null)}else if(xe){qe&&et&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Ve,we,se.width,se.height);for(let Ce=0;Ce<6;Ce++){tt=ae[Ce].mipmaps;for(let ut=0;ut<tt.length;ut++){let Wt=tt[ut];w.format!==qi?Te!==null?qe?fe&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ut,0,0,Wt.width,Wt.height,Te,Wt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ut,we,Wt.width,Wt.height,0,Wt.data):je("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):qe?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ut,0,0,Wt.width,Wt.height,Te,ye,Wt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ut,we,Wt.width,Wt.height,0,Te,ye,Wt.data)}}}else{if(tt=w.mipmaps,qe&&et){tt.length>0&&Ve++;let Ce=Ze(ae[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Ve,we,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(V){qe?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,ae[Ce].width,ae[Ce].height,Te,ye,ae[Ce].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,we,ae[Ce].width,ae[Ce].height,0,Te,ye,ae[Ce].data);for(let ut=0;ut<tt.length;ut++){let Gn=tt[ut].image[Ce].image;qe?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ut+1,0,0,Gn.width,Gn.height,Te,ye,Gn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ut+1,we,Gn.width,Gn.height,0,Te,ye,Gn.data)}}else{qe?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,Te,ye,ae[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,we,Te,ye,ae[Ce]);for(let ut=0;ut<tt.length;ut++){let Wt=tt[ut];qe?fe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ut+1,0,0,Te,ye,Wt.image[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ut+1,we,Te,ye,Wt.image[Ce])}}}P(w)&&w.mipmapsAutoUpdate===!0&&b(n.TEXTURE_CUBE_MAP),ve.__version=ce.version,w.onUpdate&&w.onUpdate(w)}D.__version=w.version}function Pt(D,w,j,pe,ce,ve){let Se=r.convert(j.format,j.colorSpace),ie=r.convert(j.type),re=M(j.internalFormat,Se,ie,j.normalized,j.colorSpace),xe=i.get(w),V=i.get(j);if(V.__renderTarget=w,!xe.__hasExternalTextures){let ae=Math.max(1,w.width>>ve),se=Math.max(1,w.height>>ve);ce===n.TEXTURE_3D||ce===n.TEXTURE_2D_ARRAY?t.texImage3D(ce,ve,re,ae,se,w.depth,0,Se,ie,null):t.texImage2D(ce,ve,re,ae,se,0,Se,ie,null)}t.bindFramebuffer(n.FRAMEBUFFER,D),Ee(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,ce,V.__webglTexture,0,lt(w)):(ce===n.TEXTURE_2D||ce>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ce<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,pe,ce,V.__webglTexture,ve),t.bindFramebuffer(n.FRAMEBUFFER,null)}function rn(D,w,j){if(n.bindRenderbuffer(n.RENDERBUFFER,D),w.depthBuffer){let pe=w.depthTexture,ce=pe&&pe.isDepthTexture?pe.type:null,ve=x(w.stencilBuffer,ce),Se=w.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Ee(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,lt(w),ve,w.width,w.height):j?n.renderbufferStorageMultisample(n.RENDERBUFFER,lt(w),ve,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,ve,w.width,w.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,Se,n.RENDERBUFFER,D)}else{let pe=w.textures;for(let ce=0;ce<pe.length;ce++){let ve=pe[ce],Se=r.convert(ve.format,ve.colorSpace),ie=r.convert(ve.type),re=M(ve.internalFormat,Se,ie,ve.normalized,ve.colorSpace);Ee(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,lt(w),re,w.width,w.height):j?n.renderbufferStorageMultisample(n.RENDERBUFFER,lt(w),re,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,re,w.width,w.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function bt(D,w,j){let pe=w.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,D),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ce=i.get(w.depthTexture);ce.__renderTarget=w;let ve=pe?w.depthTexture.image[0]:w.depthTexture.image;(!ce.__webglTexture||ve.width!==w.width||ve.height!==w.height)&&(ve.width=w.width,ve.height=w.height,w.depthTexture.needsUpdate=!0),pe?de(w.depthTexture,0):me(w.depthTexture,0);let Se=ce.__webglTexture,ie=lt(w),re=pe?n.TEXTURE_CUBE_MAP_POSITIVE_X+j:n.TEXTURE_2D,xe=w.depthTexture.format===Ps?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(w.depthTexture.format===Ts)Ee(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,xe,re,Se,0,ie):n.framebufferTexture2D(n.FRAMEBUFFER,xe,re,Se,0);else if(w.depthTexture.format===Ps)Ee(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,xe,re,Se,0,ie):n.framebufferTexture2D(n.FRAMEBUFFER,xe,re,Se,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function xn(D){let w=i.get(D),j=D.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==D.depthTexture){let pe=D.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),pe){let ce=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,pe.removeEventListener("dispose",ce)};pe.addEventListener("dispose",ce),w.__depthDisposeCallback=ce}w.__boundDepthTexture=pe}if(D.depthTexture&&!w.__autoAllocateDepthBuffer)if(j)for(let pe=0;pe<6;pe++)bt(w.__webglFramebuffer[pe],D,pe);else D.texture.mipmaps.length>0?bt(w.__webglFramebuffer[0],D,0):bt(w.__webglFramebuffer,D,0);else if(j){w.__webglDepthbuffer=[];for(let pe=0;pe<6;pe++)if(t.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[pe]),w.__webglDepthbuffer[pe]===void 0)w.__webglDepthbuffer[pe]=n.createRenderbuffer(),rn(w.__webglDepthbuffer[pe],D,!1);else{let ce=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=w.__webglDepthbuffer[pe];n.bindRenderbuffer(n.RENDERBUFFER,ve),n.framebufferRenderbuffer(n.FRAMEBUFFER,ce,n.RENDERBUFFER,ve)}}else if(D.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=n.createRenderbuffer(),rn(w.__webglDepthbuffer,D,!1);else{let ce=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=w.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,ve),n.framebufferRenderbuffer(n.FRAMEBUFFER,ce,n.RENDERBUFFER,ve)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function Qt(D,w,j){let pe=i.get(D);w!==void 0&&Pt(pe.__webglFramebuffer,D,D.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),j!==void 0&&xn(D)}function ln(D){let w=D.texture,j=i.get(D),pe=i.get(w);D.addEventListener("dispose",U),L(D);let ce=D.textures,ve=D.isWebGLCubeRenderTarget===!0,Se=ce.length>1;if(Se||(pe.__webglTexture===void 0&&(pe.__webglTexture=n.createTexture()),pe.__version=w.version,o.memory.textures++),ve){j.__webglFramebuffer=[];for(let ie=0;ie<6;ie++)if(w.mipmaps.length>0){j.__webglFramebuffer[ie]=[];for(let re=0;re<w.mipmaps.length;re++)j.__webglFramebuffer[ie][re]=n.createFramebuffer()}else j.__webglFramebuffer[ie]=n.createFramebuffer()}else{if(w.mipmaps.length>0){j.__webglFramebuffer=[];for(let ie=0;ie<w.mipmaps.length;ie++)j.__webglFramebuffer[ie]=n.createFramebuffer()}else j.__webglFramebuffer=n.createFramebuffer();if(Se)for(let ie=0,re=ce.length;ie<re;ie++){let xe=i.get(ce[ie]);xe.__webglTexture===void 0&&(xe.__webglTexture=n.createTexture(),o.memory.textures++)}if(D.samples>0&&Ee(D)===!1){j.__webglMultisampledFramebuffer=n.createFramebuffer(),j.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,j.__webglMultisampledFramebuffer);for(let ie=0;ie<ce.length;ie++){let re=ce[ie];j.__webglColorRenderbuffer[ie]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,j.__webglColorRenderbuffer[ie]);let xe=r.convert(re.format,re.colorSpace),V=r.convert(re.type),ae=M(re.internalFormat,xe,V,re.normalized,re.colorSpace,D.isXRRenderTarget===!0),se=lt(D);n.renderbufferStorageMultisample(n.RENDERBUFFER,se,ae,D.width,D.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ie,n.RENDERBUFFER,j.__webglColorRenderbuffer[ie])}n.bindRenderbuffer(n.RENDERBUFFER,null),D.depthBuffer&&(j.__webglDepthRenderbuffer=n.createRenderbuffer(),rn(j.__webglDepthRenderbuffer,D,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(ve){t.bindTexture(n.TEXTURE_CUBE_MAP,pe.__webglTexture),st(n.TEXTURE_CUBE_MAP,w);for(let ie=0;ie<6;ie++)if(w.mipmaps.length>0)for(let re=0;re<w.mipmaps.length;re++)Pt(j.__webglFramebuffer[ie][re],D,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ie,re);else Pt(j.__webglFramebuffer[ie],D,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ie,0);P(w)?b(n.TEXTURE_CUBE_MAP):w.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),t.unbindTexture()}else if(Se){for(let ie=0,re=ce.length;ie<re;ie++){let xe=ce[ie],V=i.get(xe),ae=n.TEXTURE_2D;(D.isWebGL3DRenderTarget||D.isWebGLArrayRenderTarget)&&(ae=D.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ae,V.__webglTexture),st(ae,xe),Pt(j.__webglFramebuffer,D,xe,n.COLOR_ATTACHMENT0+ie,ae,0),P(xe)&&b(ae)}t.unbindTexture()}else{let ie=n.TEXTURE_2D;if((D.isWebGL3DRenderTarget||D.isWebGLArrayRenderTarget)&&(ie=D.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ie,pe.__webglTexture),st(ie,w),w.mipmaps.length>0)for(let re=0;re<w.mipmaps.length;re++)Pt(j.__webglFramebuffer[re],D,w,n.COLOR_ATTACHMENT0,ie,re);else Pt(j.__webglFramebuffer,D,w,n.COLOR_ATTACHMENT0,ie,0);P(w)?b(ie):w.mipmaps.length>0&&n.texParameteri(ie,n.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),t.unbindTexture()}D.depthBuffer&&xn(D)}function G(D){let w=D.textures;for(let j=0,pe=w.length;j<pe;j++){let ce=w[j];if(P(ce)&&ce.mipmapsAutoUpdate===!0){let ve=C(D),Se=i.get(ce).__webglTexture;t.bindTexture(ve,Se),b(ve),t.unbindTexture()}}}let Pe=[];function Je(D){if(D.samples>0){if(Ee(D)===!1){let w=D.textures,j=D.width,pe=D.height,ce=n.COLOR_BUFFER_BIT,ve=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Se=i.get(D),ie=w.length>1;if(ie)for(let xe=0;xe<w.length;xe++)t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+xe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+xe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,Se.__webglMultisampledFramebuffer),D.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Se.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Se.__webglFramebuffer);for(let xe=0;xe<w.length;xe++){if(D.resolveDepthBuffer&&(D.depthBuffer&&(ce|=n.DEPTH_BUFFER_BIT),D.stencilBuffer&&D.resolveStencilBuffer&&(ce|=n.STENCIL_BUFFER_BIT)),ie){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,Se.__webglColorRenderbuffer[xe]);let V=i.get(w[xe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,V,0)}n.blitFramebuffer(0,0,j,pe,0,0,j,pe,ce,n.NEAREST),l===!0&&(Pe.length=0,Pe.push(n.COLOR_ATTACHMENT0+xe),D.depthBuffer&&D.storeMultisampledDepthBuffer===!1&&Pe.push(ve),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Pe))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),ie)for(let xe=0;xe<w.length;xe++){t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+xe,n.RENDERBUFFER,Se.__webglColorRenderbuffer[xe]);let V=i.get(w[xe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+xe,n.TEXTURE_2D,V,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Se.__webglMultisampledFramebuffer)}else if(D.depthBuffer&&D.storeMultisampledDepthBuffer===!1&&l){let w=D.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[w])}}}function lt(D){return Math.min(s.maxSamples,D.samples)}function Ee(D){let w=i.get(D);return D.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function zt(D){let w=o.render.frame;u.get(D)!==w&&(u.set(D,w),D.update())}function We(D,w){let j=D.colorSpace,pe=D.format,ce=D.type;return D.isCompressedTexture===!0||D.isVideoTexture===!0||j!==Pa&&j!==Is&&(St.getTransfer(j)===Lt?(pe!==qi||ce!==si)&&je("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):it("WebGLTextures: Unsupported texture color space:",j)),w}function Ze(D){return typeof HTMLImageElement<"u"&&D instanceof HTMLImageElement?(c.width=D.naturalWidth||D.width,c.height=D.naturalHeight||D.height):typeof VideoFrame<"u"&&D instanceof VideoFrame?(c.width=D.displayWidth,c.height=D.displayHeight):(c.width=D.width,c.height=D.height),c}this.allocateTextureUnit=he,this.resetTextureUnits=Z,this.getTextureUnits=te,this.setTextureUnits=le,this.setTexture2D=me,this.setTexture2DArray=ge,this.setTexture3D=oe,this.setTextureCube=de,this.rebindTextures=Qt,this.setupRenderTarget=ln,this.updateRenderTargetMipmap=G,this.updateMultisampleRenderTarget=Je,this.setupDepthRenderbuffer=xn,this.setupFrameBufferTexture=Pt,this.useMultisampledRTT=Ee,this.dispose=N}function qE(n,e){function t(i,s=Is){let r,o=St.getTransfer(s);if(i===si)return n.UNSIGNED_BYTE;if(i===dh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===fh)return n.UNSIGNED_SHORT_5_5_5_1;if(i===pf)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===mf)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===df)return n.BYTE;if(i===ff)return n.SHORT;if(i===Yo)return n.UNSIGNED_SHORT;if(i===uh)return n.INT;if(i===Gi)return n.UNSIGNED_INT;if(i===Hi)return n.FLOAT;if(i===Wi)return n.HALF_FLOAT;if(i===gf)return n.ALPHA;if(i===_f)return n.RGB;if(i===qi)return n.RGBA;if(i===Ts)return n.DEPTH_COMPONENT;if(i===Ps)return n.DEPTH_STENCIL;if(i===xf)return n.RED;if(i===ph)return n.RED_INTEGER;if(i===sr)return n.RG;if(i===mh)return n.RG_INTEGER;if(i===gh)return n.RGBA_INTEGER;if(i===ol||i===al||i===ll||i===cl)if(o===Lt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===ol)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===al)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===ll)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===cl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===ol)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===al)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===ll)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===cl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===_h||i===xh||i===yh||i===vh)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===_h)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===xh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===yh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===vh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Sh||i===Mh||i===bh||i===wh||i===Eh||i===hl||i===Th)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Sh||i===Mh)return o===Lt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===bh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===wh)return r.COMPRESSED_R11_EAC;if(i===Eh)return r.COMPRESSED_SIGNED_R11_EAC;if(i===hl)return r.COMPRESSED_RG11_EAC;if(i===Th)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Ah||i===Rh||i===Ch||i===Ph||i===Ih||i===Lh||i===Dh||i===Nh||i===Uh||i===Fh||i===Oh||i===Bh||i===kh||i===zh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Ah)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Rh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Ch)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Ph)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Ih)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Lh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Dh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Nh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Uh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Fh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Oh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Bh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===kh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===zh)return o===Lt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Vh||i===Gh||i===Hh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Vh)return o===Lt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Gh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Hh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Wh||i===qh||i===ul||i===Xh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Wh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===qh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===ul)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Xh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Fr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var XE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,YE=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,qf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new Ha(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Ti({vertexShader:XE,fragmentShader:YE,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new zn(new Lr(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Xf=class extends ki{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,d=null,h=null,m=null,g=null,_=typeof XRWebGLBinding<"u",f=new qf,p={},v=t.getContextAttributes(),P=null,b=null,C=[],M=[],x=new Ke,y=null,L=null,R=new jn;R.viewport=new Dt;let I=new jn;I.viewport=new Dt;let U=[R,I],k=new oh,E=null,N=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let me=C[Q];return me===void 0&&(me=new ko,C[Q]=me),me.getTargetRaySpace()},this.getControllerGrip=function(Q){let me=C[Q];return me===void 0&&(me=new ko,C[Q]=me),me.getGripSpace()},this.getHand=function(Q){let me=C[Q];return me===void 0&&(me=new ko,C[Q]=me),me.getHandSpace()};function z(Q){let me=M.indexOf(Q.inputSource);if(me===-1)return;let ge=C[me];ge!==void 0&&(ge.update(Q.inputSource,Q.frame,c||o),ge.dispatchEvent({type:Q.type,data:Q.inputSource}))}function O(){s.removeEventListener("select",z),s.removeEventListener("selectstart",z),s.removeEventListener("selectend",z),s.removeEventListener("squeeze",z),s.removeEventListener("squeezestart",z),s.removeEventListener("squeezeend",z),s.removeEventListener("end",O),s.removeEventListener("inputsourceschange",X);for(let Q=0;Q<C.length;Q++){let me=M[Q];me!==null&&(M[Q]=null,C[Q].disconnect(me))}E=null,N=null,f.reset();for(let Q in p)delete p[Q];if(e.setRenderTarget(P),m=null,h=null,d=null,s=null,b=null,he.stop(),i.isPresenting=!1,e.setPixelRatio(y),e.setSize(x.width,x.height,!1),L!==null){let Q=L.camera;Q.fov=L.fov,Q.zoom=L.zoom,Q.updateProjectionMatrix(),L=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,i.isPresenting===!0&&je("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,i.isPresenting===!0&&je("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return h!==null?h:m},this.getBinding=function(){return d===null&&_&&(d=new XRWebGLBinding(s,t)),d},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(P=e.getRenderTarget(),s.addEventListener("select",z),s.addEventListener("selectstart",z),s.addEventListener("selectend",z),s.addEventListener("squeeze",z),s.addEventListener("squeezestart",z),s.addEventListener("squeezeend",z),s.addEventListener("end",O),s.addEventListener("inputsourceschange",X),v.xrCompatible!==!0&&await t.makeXRCompatible(),y=e.getPixelRatio(),e.getSize(x),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let ge=null,oe=null,de=null;v.depth&&(de=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ge=v.stencil?Ps:Ts,oe=v.stencil?Fr:Gi);let Ne={colorFormat:t.RGBA8,depthFormat:de,scaleFactor:r};d=this.getBinding(),h=d.createProjectionLayer(Ne),s.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(h.textureWidth,h.textureHeight,!1),b=new _i(h.textureWidth,h.textureHeight,{format:qi,type:si,depthTexture:new Rs(h.textureWidth,h.textureHeight,oe,void 0,void 0,void 0,void 0,void 0,void 0,ge),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let ge={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};m=new XRWebGLLayer(s,t,ge),s.updateRenderState({baseLayer:m}),e.setPixelRatio(1),e.setSize(m.framebufferWidth,m.framebufferHeight,!1),b=new _i(m.framebufferWidth,m.framebufferHeight,{format:qi,type:si,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:m.ignoreDepthValues===!1,resolveStencilBuffer:m.ignoreDepthValues===!1,storeMultisampledDepthBuffer:m.ignoreDepthValues===!1,storeMultisampledStencilBuffer:m.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),he.setContext(s),he.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return f.getDepthTexture()};function X(Q){for(let me=0;me<Q.removed.length;me++){let ge=Q.removed[me],oe=M.indexOf(ge);oe>=0&&(M[oe]=null,C[oe].disconnect(ge))}for(let me=0;me<Q.added.length;me++){let ge=Q.added[me],oe=M.indexOf(ge);if(oe===-1){for(let Ne=0;Ne<C.length;Ne++)if(Ne>=M.length){M.push(ge),oe=Ne;break}else if(M[Ne]===null){M[Ne]=ge,oe=Ne;break}if(oe===-1)break}let de=C[oe];de&&de.connect(ge)}}function H(Q,me){me===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(me.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let me=Q.near,ge=Q.far;f.texture!==null&&(f.depthNear>0&&(me=f.depthNear),f.depthFar>0&&(ge=f.depthFar)),k.near=I.near=R.near=me,k.far=I.far=R.far=ge,(E!==k.near||N!==k.far)&&(s.updateRenderState({depthNear:k.near,depthFar:k.far}),E=k.near,N=k.far),k.layers.mask=Q.layers.mask|6,R.layers.mask=k.layers.mask&-5,I.layers.mask=k.layers.mask&-3;let oe=Q.parent,de=k.cameras;H(k,oe);for(let Ne=0;Ne<de.length;Ne++)H(de[Ne],oe);k.projectionMatrix.copy(R.projectionMatrix),k.projectionMatrixInverse.copy(R.projectionMatrixInverse),L===null&&Q.isPerspectiveCamera&&(L={camera:Q,fov:Q.fov,zoom:Q.zoom}),Z(Q,k,oe)};function Z(Q,me,ge){ge===null?Q.matrix.copy(me.matrixWorld):(Q.matrix.copy(ge.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(me.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(me.projectionMatrix),Q.projectionMatrixInverse.copy(me.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=Oo*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return k},this.getFoveation=function(){if(!(h===null&&m===null))return l},this.setFoveation=function(Q){l=Q,h!==null&&(h.fixedFoveation=Q),m!==null&&m.fixedFoveation!==void 0&&(m.fixedFoveation=Q)},this.hasDepthSensing=function(){return f.texture!==null},this.getDepthSensingMesh=function(){return f.getMesh(k)},this.getCameraTexture=function(Q){return p[Q]};let te=null;function le(Q,me){if(u=me.getViewerPose(c||o),g=me,u!==null){let ge=u.views;m!==null&&(e.setRenderTargetFramebuffer(b,m.framebuffer),e.setRenderTarget(b));let oe=!1;ge.length!==k.cameras.length&&(k.cameras.length=0,oe=!0);for(let Be=0;Be<ge.length;Be++){let st=ge[Be],at=null;if(m!==null)at=m.getViewport(st);else{let pt=d.getViewSubImage(h,st);at=pt.viewport,Be===0&&(e.setRenderTargetTextures(b,pt.colorTexture,pt.depthStencilTexture),e.setRenderTarget(b))}let $e=U[Be];$e===void 0&&($e=new jn,$e.layers.enable(Be),$e.viewport=new Dt,U[Be]=$e),$e.matrix.fromArray(st.transform.matrix),$e.matrix.decompose($e.position,$e.quaternion,$e.scale),$e.projectionMatrix.fromArray(st.projectionMatrix),$e.projectionMatrixInverse.copy($e.projectionMatrix).invert(),$e.viewport.set(at.x,at.y,at.width,at.height),Be===0&&(k.matrix.copy($e.matrix),k.matrix.decompose(k.position,k.quaternion,k.scale)),oe===!0&&k.cameras.push($e)}let de=s.enabledFeatures;if(de&&de.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){d=i.getBinding();let Be=d.getDepthInformation(ge[0]);Be&&Be.isValid&&Be.texture&&f.init(Be,s.renderState)}if(de&&de.includes("camera-access")&&_){e.state.unbindTexture(),d=i.getBinding();for(let Be=0;Be<ge.length;Be++){let st=ge[Be].camera;if(st){let at=p[st];at||(at=new Ha,p[st]=at);let $e=d.getCameraImage(st);at.sourceTexture=$e}}}}for(let ge=0;ge<C.length;ge++){let oe=M[ge],de=C[ge];oe!==null&&de!==void 0&&de.update(oe,me,c||o)}te&&te(Q,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),g=null}let he=new A_;he.setAnimationLoop(le),this.setAnimationLoop=function(Q){te=Q},this.dispose=function(){}}},$E=new Bt,O_=new rt;O_.set(-1,0,0,0,1,0,0,0,1);function ZE(n,e){function t(f,p){f.matrixAutoUpdate===!0&&f.updateMatrix(),p.value.copy(f.matrix)}function i(f,p){p.color.getRGB(f.fogColor.value,Rf(n)),p.isFog?(f.fogNear.value=p.near,f.fogFar.value=p.far):p.isFogExp2&&(f.fogDensity.value=p.density)}function s(f,p,v,P,b){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(f,p):p.isMeshLambertMaterial?(r(f,p),p.envMap&&(f.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(f,p),d(f,p)):p.isMeshPhongMaterial?(r(f,p),u(f,p),p.envMap&&(f.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(f,p),h(f,p),p.isMeshPhysicalMaterial&&m(f,p,b)):p.isMeshMatcapMaterial?(r(f,p),g(f,p)):p.isMeshDepthMaterial?r(f,p):p.isMeshDistanceMaterial?(r(f,p),_(f,p)):p.isMeshNormalMaterial?r(f,p):p.isLineBasicMaterial?(o(f,p),p.isLineDashedMaterial&&a(f,p)):p.isPointsMaterial?l(f,p,v,P):p.isSpriteMaterial?c(f,p):p.isShadowMaterial?(f.color.value.copy(p.color),f.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(f,p){f.opacity.value=p.opacity,p.color&&f.diffuse.value.copy(p.color),p.emissive&&f.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(f.map.value=p.map,t(p.map,f.mapTransform)),p.alphaMap&&(f.alphaMap.value=p.alphaMap,t(p.alphaMap,f.alphaMapTransform)),p.bumpMap&&(f.bumpMap.value=p.bumpMap,t(p.bumpMap,f.bumpMapTransform),f.bumpScale.value=p.bumpScale,p.side===ti&&(f.bumpScale.value*=-1)),p.normalMap&&(f.normalMap.value=p.normalMap,t(p.normalMap,f.normalMapTransform),f.normalScale.value.copy(p.normalScale),p.side===ti&&f.normalScale.value.negate()),p.displacementMap&&(f.displacementMap.value=p.displacementMap,t(p.displacementMap,f.displacementMapTransform),f.displacementScale.value=p.displacementScale,f.displacementBias.value=p.displacementBias),p.emissiveMap&&(f.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,f.emissiveMapTransform)),p.specularMap&&(f.specularMap.value=p.specularMap,t(p.specularMap,f.specularMapTransform)),p.alphaTest>0&&(f.alphaTest.value=p.alphaTest);let v=e.get(p),P=v.envMap,b=v.envMapRotation;P&&(f.envMap.value=P,f.envMapRotation.value.setFromMatrix4($E.makeRotationFromEuler(b)).transpose(),P.isCubeTexture&&P.isRenderTargetTexture===!1&&f.envMapRotation.value.premultiply(O_),f.reflectivity.value=p.reflectivity,f.ior.value=p.ior,f.refractionRatio.value=p.refractionRatio),p.lightMap&&(f.lightMap.value=p.lightMap,f.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,f.lightMapTransform)),p.aoMap&&(f.aoMap.value=p.aoMap,f.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,f.aoMapTransform))}function o(f,p){f.diffuse.value.copy(p.color),f.opacity.value=p.opacity,p.map&&(f.map.value=p.map,t(p.map,f.mapTransform))}function a(f,p){f.dashSize.value=p.dashSize,f.totalSize.value=p.dashSize+p.gapSize,f.scale.value=p.scale}function l(f,p,v,P){f.diffuse.value.copy(p.color),f.opacity.value=p.opacity,f.size.value=p.size*v,f.scale.value=P*.5,p.map&&(f.map.value=p.map,t(p.map,f.uvTransform)),p.alphaMap&&(f.alphaMap.value=p.alphaMap,t(p.alphaMap,f.alphaMapTransform)),p.alphaTest>0&&(f.alphaTest.value=p.alphaTest)}function c(f,p){f.diffuse.value.copy(p.color),f.opacity.value=p.opacity,f.rotation.value=p.rotation,p.map&&(f.map.value=p.map,t(p.map,f.mapTransform)),p.alphaMap&&(f.alphaMap.value=p.alphaMap,t(p.alphaMap,f.alphaMapTransform)),p.alphaTest>0&&(f.alphaTest.value=p.alphaTest)}function u(f,p){f.specular.value.copy(p.specular),f.shininess.value=Math.max(p.shininess,1e-4)}function d(f,p){p.gradientMap&&(f.gradientMap.value=p.gradientMap)}function h(f,p){f.metalness.value=p.metalness,p.metalnessMap&&(f.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,f.metalnessMapTransform)),f.roughness.value=p.roughness,p.roughnessMap&&(f.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,f.roughnessMapTransform)),p.envMap&&(f.envMapIntensity.value=p.envMapIntensity)}function m(f,p,v){f.ior.value=p.ior,p.diffuseRoughness>0&&(f.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(f.diffuseRoughnessMap.value=p.diffuseRoughnessMap,t(p.diffuseRoughnessMap,f.diffuseRoughnessMapTransform))),p.sheen>0&&(f.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),f.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(f.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,f.sheenColorMapTransform)),p.sheenRoughnessMap&&(f.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,f.sheenRoughnessMapTransform))),p.clearcoat>0&&(f.clearcoat.value=p.clearcoat,f.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(f.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,f.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(f.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,f.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(f.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,f.clearcoatNormalMapTransform),f.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===ti&&f.clearcoatNormalScale.value.negate())),p.dispersion>0&&(f.dispersion.value=p.dispersion),p.retroreflectivity>0&&(f.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(f.iridescence.value=p.iridescence,f.iridescenceIOR.value=p.iridescenceIOR,f.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,f.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(f.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,f.iridescenceMapTransform)),p.iridescenceThicknessMap&&(f.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,f.iridescenceThicknessMapTransform))),p.transmission>0&&(f.transmission.value=p.transmission,f.transmissionSamplerMap.value=v.texture,f.transmissionSamplerSize.value.set(v.width,v.height),p.transmissionMap&&(f.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,f.transmissionMapTransform)),f.thickness.value=p.thickness,p.thicknessMap&&(f.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,f.thicknessMapTransform)),f.attenuationDistance.value=p.attenuationDistance,f.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(f.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(f.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,f.anisotropyMapTransform))),f.specularIntensity.value=p.specularIntensity,f.specularColor.value.copy(p.specularColor),p.specularColorMap&&(f.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,f.specularColorMapTransform)),p.specularIntensityMap&&(f.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,f.specularIntensityMapTransform))}function g(f,p){p.matcap&&(f.matcap.value=p.matcap)}function _(f,p){let v=e.get(p).light;f.referencePosition.value.setFromMatrixPosition(v.matrixWorld),f.nearDistance.value=v.shadow.camera.near,f.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function jE(n,e,t,i){let s={},r={};function o(v,P){let b=P.program;i.uniformBlockBinding(v,b,s[v.id])}function a(v,P){let b=s[v.id];b===void 0&&(g(v),b=l(v),s[v.id]=b,v.addEventListener("dispose",f));let C=P.program;i.updateUBOMapping(v,C);let M=e.render.frame;r[v.id]!==M&&(c(v),r[v.id]=M)}function l(v){let P=n.createBuffer(),b=v.__size,C=v.usage;return n.bindBuffer(n.UNIFORM_BUFFER,P),n.bufferData(n.UNIFORM_BUFFER,b,C),n.bindBuffer(n.UNIFORM_BUFFER,null),P}function c(v){let P=s[v.id],b=v.uniforms,C=v.__cache;n.bindBuffer(n.UNIFORM_BUFFER,P);for(let M=0,x=b.length;M<x;M++){let y=b[M];if(Array.isArray(y))for(let L=0,R=y.length;L<R;L++)u(y[L],M,L,C);else u(y,M,0,C)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(v,P,b,C){if(h(v,P,b,C)===!0){let M=v.__offset,x=v.value;if(Array.isArray(x)){let y=0;for(let L=0;L<x.length;L++){let R=x[L],I=_(R,!0);d(R,v.__data,y),y+=I.storage/Float32Array.BYTES_PER_ELEMENT}}else d(x,v.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,M,v.__data)}}function d(v,P,b){typeof v=="number"||typeof v=="boolean"?P[b]=v:v.isMatrix3?(P[b]=v.elements[0],P[b+1]=v.elements[1],P[b+2]=v.elements[2],P[b+3]=0,P[b+4]=v.elements[3],P[b+5]=v.elements[4],P[b+6]=v.elements[5],P[b+7]=0,P[b+8]=v.elements[6],P[b+9]=v.elements[7],P[b+10]=v.elements[8],P[b+11]=0):ArrayBuffer.isView(v)?P.set(v.subarray(0,P.length-b),b):v.toArray(P,b)}function h(v,P,b,C){let M=v.value,x=P+"_"+b;if(Array.isArray(M)){C[x]===void 0&&(C[x]=[]);let y=C[x],L=!1;for(let R=0;R<M.length;R++)m(M[R],y,R)===!0&&(L=!0);return L}return m(M,C,x)}function m(v,P,b){if(P[b]===void 0)return typeof v=="number"||typeof v=="boolean"?P[b]=v:ArrayBuffer.isView(v)?P[b]=v.slice():P[b]=v.clone(),!0;{let C=P[b];if(typeof v=="number"||typeof v=="boolean"){if(C!==v)return P[b]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(C.equals(v)===!1)return C.copy(v),!0}}return!1}function g(v){let P=v.uniforms,b=0,C=16;for(let x=0,y=P.length;x<y;x++){let L=Array.isArray(P[x])?P[x]:[P[x]];for(let R=0,I=L.length;R<I;R++){let U=L[R],k=Array.isArray(U.value)?U.value:[U.value],E=Array.isArray(P[x])||Array.isArray(U.value),N=b;for(let O=0,X=k.length;O<X;O++){let H=k[O],Z=_(H,E),te=b%C,le=te%Z.boundary,he=te+le;b+=le,he!==0&&C-he<Z.storage&&(b+=C-he),O===0&&(N=b),b+=Z.storage}let z=U.type==="int"?Int32Array:U.type==="uint"?Uint32Array:Float32Array;U.__data=new z((b-N)/Float32Array.BYTES_PER_ELEMENT),U.__offset=N}}let M=b%C;return M>0&&(b+=C-M),v.__size=b,v.__cache={},this}function _(v,P){let b={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(b.boundary=4,b.storage=4):v.isVector2?(b.boundary=8,b.storage=8):v.isVector3||v.isColor?(b.boundary=16,b.storage=12):v.isVector4?(b.boundary=16,b.storage=16):v.isMatrix3?(b.boundary=16,b.storage=48):v.isMatrix4?(b.boundary=16,b.storage=64):v.isTexture?je("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(b.boundary=16,b.storage=v.byteLength):je("WebGLRenderer: Unsupported uniform value type.",v),P===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function f(v){let P=v.target;P.removeEventListener("dispose",f),n.deleteBuffer(s[P.id]),delete s[P.id],delete r[P.id]}function p(){for(let v in s)n.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:p}}var JE=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),as=null;function KE(){return as===null&&(as=new zc(JE,16,16,sr,Wi),as.name="DFG_LUT",as.minFilter=Kn,as.magFilter=Kn,as.wrapS=is,as.wrapT=is,as.generateMipmaps=!1,as.needsUpdate=!0),as}var Kh=class{constructor(e={}){let{canvas:t=Q0(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:h=!1,outputBufferType:m=si}=e;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let _=m,f=new Set([gh,mh,ph]),p=new Set([si,Gi,Yo,Fr,dh,fh]),v=new Uint32Array(4),P=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},C=null,M=null,x=[],y=[],L=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=os,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let R=this,I=!1,U=null,k=null,E=null,N=null;this._outputColorSpace=Zn;let z=0,O=0,X=null,H=-1,Z=null,te=new Dt,le=new Dt,he=null,Q=new ht(0),me=0,ge=t.width,oe=t.height,de=1,Ne=null,Ye=null,Be=new Dt(0,0,ge,oe),st=new Dt(0,0,ge,oe),at=!1,$e=new Zs,pt=new Vc,Mt=!1,jt=!1,Pt=new Bt,rn=new Y,bt=new Dt,xn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Qt=!1;function ln(){return X===null?de:1}let G=i;function Pe(A,q){return t.getContext(A,q)}let Je,lt,Ee,zt,We,Ze,D,w,j,pe,ce,ve,Se,ie,re,xe,V,ae,se,Te,ye,we,qe;try{let A={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:d};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Ve,!1),t.addEventListener("webglcontextrestored",tt,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),G===null){let q="webgl2";if(G=Pe(q,A),G===null)throw Pe(q)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}et()}catch(A){throw t.removeEventListener("webglcontextlost",Ve,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),it("WebGLRenderer: "+A.message),A}function et(){Je=new cw(G),Je.init(),ye=new qE(G,Je),lt=new K1(G,Je,e,ye),Ee=new HE(G,Je),lt.reversedDepthBuffer&&h&&Ee.buffers.depth.setReversed(!0),k=G.createFramebuffer(),E=G.createFramebuffer(),N=G.createFramebuffer(),zt=new dw(G),We=new CE,Ze=new WE(G,Je,Ee,We,lt,ye,zt),D=new lw(R),w=new pM(G),we=new j1(G,w),j=new hw(G,w,zt,we),pe=new pw(G,j,w,we,zt),ae=new fw(G,lt,Ze),re=new Q1(We),ce=new RE(R,D,Je,lt,we,re),ve=new ZE(R,We),Se=new IE,ie=new OE(Je),V=new Z1(R,D,Ee,pe,g,l),xe=new GE(R,pe,lt),qe=new jE(G,zt,lt,Ee),se=new J1(G,Je,zt),Te=new uw(G,Je,zt),zt.programs=ce.programs,R.capabilities=lt,R.extensions=Je,R.properties=We,R.renderLists=Se,R.shadowMap=xe,R.state=Ee,R.info=zt}_!==si&&(L=new gw(_,t.width,t.height,a,s,r));let fe=new Xf(R,G);this.xr=fe,this.getContext=function(){return G},this.getContextAttributes=function(){return G.getContextAttributes()},this.forceContextLoss=function(){let A=Je.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){let A=Je.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return de},this.setPixelRatio=function(A){A!==void 0&&(de=A,this.setSize(ge,oe,!1))},this.getSize=function(A){return A.set(ge,oe)},this.setSize=function(A,q,ne=!0){if(fe.isPresenting){je("WebGLRenderer: Can't change size while VR device is presenting.");return}ge=A,oe=q,t.width=Math.floor(A*de),t.height=Math.floor(q*de),ne===!0&&(t.style.width=A+"px",t.style.height=q+"px"),L!==null&&L.setSize(t.width,t.height),this.setViewport(0,0,A,q)},this.getDrawingBufferSize=function(A){return A.set(ge*de,oe*de).floor()},this.setDrawingBufferSize=function(A,q,ne){ge=A,oe=q,de=ne,t.width=Math.floor(A*ne),t.height=Math.floor(q*ne),this.setViewport(0,0,A,q)},this.setEffects=function(A){if(_===si){it("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(A){for(let q=0;q<A.length;q++)if(A[q].isOutputPass===!0){je("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}L.setEffects(A||[])},this.getCurrentViewport=function(A){return A.copy(te)},this.getViewport=function(A){return A.copy(Be)},this.setViewport=function(A,q,ne,J){A.isVector4?Be.set(A.x,A.y,A.z,A.w):Be.set(A,q,ne,J),Ee.viewport(te.copy(Be).multiplyScalar(ln()).round())},this.getScissor=function(A){return A.copy(st)},this.setScissor=function(A,q,ne,J){A.isVector4?st.set(A.x,A.y,A.z,A.w):st.set(A,q,ne,J),Ee.scissor(le.copy(st).multiplyScalar(ln()).round())},this.getScissorTest=function(){return at},this.setScissorTest=function(A){Ee.setScissorTest(at=A)},this.setOpaqueSort=function(A){Ne=A},this.setTransparentSort=function(A){Ye=A},this.getClearColor=function(A){return A.copy(V.getClearColor())},this.setClearColor=function(){V.setClearColor(...arguments)},this.getClearAlpha=function(){return V.getClearAlpha()},this.setClearAlpha=function(){V.setClearAlpha(...arguments)},this.clear=function(A=!0,q=!0,ne=!0){let J=0;if(A){let K=!1;if(X!==null){let Ae=X.texture.format;K=f.has(Ae)}if(K){let Ae=X.texture.type,Le=p.has(Ae),Re=V.getClearColor(),De=V.getClearAlpha(),He=Re.r,nt=Re.g,gt=Re.b;Le?(v[0]=He,v[1]=nt,v[2]=gt,v[3]=De,G.clearBufferuiv(G.COLOR,0,v)):(P[0]=He,P[1]=nt,P[2]=gt,P[3]=De,G.clearBufferiv(G.COLOR,0,P))}else J|=G.COLOR_BUFFER_BIT}q&&(J|=G.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),ne&&(J|=G.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),J!==0&&G.clear(J)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(A){A.setRenderer(this),U=A},this.dispose=function(){t.removeEventListener("webglcontextlost",Ve,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),V.dispose(),Se.dispose(),ie.dispose(),Ze.dispose(),We.dispose(),D.dispose(),pe.dispose(),j.dispose(),we.dispose(),qe.dispose(),ce.dispose(),fe.dispose(),fe.removeEventListener("sessionstart",vl),fe.removeEventListener("sessionend",Xi),ds.stop()};function Ve(A){A.preventDefault(),Da("WebGLRenderer: Context Lost."),I=!0}function tt(){Da("WebGLRenderer: Context Restored."),I=!1;let A=zt.autoReset,q=xe.enabled,ne=xe.autoUpdate,J=xe.needsUpdate,K=xe.type;et(),zt.autoReset=A,xe.enabled=q,xe.autoUpdate=ne,xe.needsUpdate=J,xe.type=K}function Ce(A){it("WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function ut(A){let q=A.target;q.removeEventListener("dispose",ut),Wt(q)}function Wt(A){Gn(A),We.remove(A)}function Gn(A){let q=We.get(A).programs;q!==void 0&&(q.forEach(function(ne){ce.releaseProgram(ne)}),A.isShaderMaterial&&ce.releaseShaderCache(A))}this.renderBufferDirect=function(A,q,ne,J,K,Ae){q===null&&(q=xn);let Le=K.isMesh&&K.matrixWorld.determinantAffine()<0,Re=ta(A,q,ne,J,K);Ee.setMaterial(J,Le);let De=ne.index,He=1;if(J.wireframe===!0){if(De=j.getWireframeAttribute(ne),De===void 0)return;He=2}let nt=ne.drawRange,gt=ne.attributes.position,Ge=nt.start*He,_t=(nt.start+nt.count)*He;Ae!==null&&(Ge=Math.max(Ge,Ae.start*He),_t=Math.min(_t,(Ae.start+Ae.count)*He)),De!==null?(Ge=Math.max(Ge,0),_t=Math.min(_t,De.count)):gt!=null&&(Ge=Math.max(Ge,0),_t=Math.min(_t,gt.count));let Kt=_t-Ge;if(Kt<0||Kt===1/0)return;we.setup(K,J,Re,ne,De);let Nt,Ut=se;if(De!==null&&(Nt=w.get(De),Ut=Te,Ut.setIndex(Nt)),K.isMesh)J.wireframe===!0?(Ee.setLineWidth(J.wireframeLinewidth*ln()),Ut.setMode(G.LINES)):Ut.setMode(G.TRIANGLES);else if(K.isLine){let yn=J.linewidth;yn===void 0&&(yn=1),Ee.setLineWidth(yn*ln()),K.isLineSegments?Ut.setMode(G.LINES):K.isLineLoop?Ut.setMode(G.LINE_LOOP):Ut.setMode(G.LINE_STRIP)}else K.isPoints?Ut.setMode(G.POINTS):K.isSprite&&Ut.setMode(G.TRIANGLES);if(K.isBatchedMesh)if(Je.get("WEBGL_multi_draw"))Ut.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let yn=K._multiDrawStarts,ke=K._multiDrawCounts,cn=K._multiDrawCount,yt=De?w.get(De).bytesPerElement:1,ps=We.get(J).currentProgram.getUniforms();for(let hn=0;hn<cn;hn++)ps.setValue(G,"_gl_DrawID",hn),Ut.render(yn[hn]/yt,ke[hn])}else if(K.isInstancedMesh)Ut.renderInstances(Ge,Kt,K.count);else if(ne.isInstancedBufferGeometry){let yn=ne._maxInstanceCount!==void 0?ne._maxInstanceCount:1/0,ke=Math.min(ne.instanceCount,yn);Ut.renderInstances(Ge,Kt,ke)}else Ut.render(Ge,Kt)};function Ko(A,q,ne,J){U!==null&&A.isNodeMaterial&&U.setObject(J,A),Mt===!0&&re.setState(A,ne,!1),A.transparent===!0&&A.side===rs&&A.forceSinglePass===!1?(A.side=ti,A.needsUpdate=!0,Yi(A,q,J),A.side=ir,A.needsUpdate=!0,Yi(A,q,J),A.side=rs):Yi(A,q,J)}this.compile=function(A,q,ne=null){ne===null&&(ne=A),U!==null&&U.renderStart(A,q,ne),M=ie.get(ne),M.init(q),y.push(M),ne.traverseVisible(function(K){K.isLight&&K.layers.test(q.layers)&&(M.pushLight(K),K.castShadow&&M.pushShadow(K))}),A!==ne&&A.traverseVisible(function(K){K.isLight&&K.layers.test(q.layers)&&(M.pushLight(K),K.castShadow&&M.pushShadow(K))}),M.setupLights(),U!==null&&U.updateLights(M.state.lightsArray),jt=this.localClippingEnabled,Mt=re.init(this.clippingPlanes,jt),Mt===!0&&re.setGlobalState(this.clippingPlanes,q),U!==null&&xe.render(M.state.shadowsArray,ne,q);let J=new Set;return A.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Ae=K.material;if(Ae)if(Array.isArray(Ae))for(let Le=0;Le<Ae.length;Le++){let Re=Ae[Le];Ko(Re,ne,q,K),J.add(Re)}else Ko(Ae,ne,q,K),J.add(Ae)}),M=y.pop(),U!==null&&U.renderEnd(),J},this.compileAsync=function(A,q,ne=null){let J=this.compile(A,q,ne);return new Promise(K=>{function Ae(){if(J.forEach(function(Le){let De=We.get(Le).currentProgram;(De===void 0||De.isReady())&&J.delete(Le)}),J.size===0){K(A);return}setTimeout(Ae,10)}Je.get("KHR_parallel_shader_compile")!==null?Ae():setTimeout(Ae,10)})};let Gr=null;function du(A){Gr&&Gr(A)}function vl(){ds.stop()}function Xi(){ds.start()}let ds=new A_;ds.setAnimationLoop(du),typeof self<"u"&&ds.setContext(self),this.setAnimationLoop=function(A){Gr=A,fe.setAnimationLoop(A),A===null?ds.stop():ds.start()},fe.addEventListener("sessionstart",vl),fe.addEventListener("sessionend",Xi),this.render=function(A,q){if(q!==void 0&&q.isCamera!==!0){it("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;U!==null&&U.renderStart(A,q);let ne=fe.enabled===!0&&fe.isPresenting===!0,J=L!==null&&(X===null||ne)&&L.begin(R,X);if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),q.parent===null&&q.matrixWorldAutoUpdate===!0&&q.updateMatrixWorld(),fe.enabled===!0&&fe.isPresenting===!0&&(L===null||L.isCompositing()===!1)&&(fe.cameraAutoUpdate===!0&&fe.updateCamera(q),q=fe.getCamera()),A.isScene===!0&&A.onBeforeRender(R,A,q,X),M=ie.get(A,y.length),M.init(q),M.state.textureUnits=Ze.getTextureUnits(),y.push(M),Pt.multiplyMatrices(q.projectionMatrix,q.matrixWorldInverse),q.isArrayCamera?pt.setFromArrayCamera(q):$e.setFromProjectionMatrix(Pt,Ei,q.reversedDepth),jt=this.localClippingEnabled,Mt=re.init(this.clippingPlanes,jt),C=Se.get(A,x.length),C.init(),x.push(C),this.info.render.frame++,fe.enabled===!0&&fe.isPresenting===!0){let Le=R.xr.getDepthSensingMesh();Le!==null&&fs(Le,q,-1/0,R.sortObjects)}fs(A,q,0,R.sortObjects),C.finish(),U!==null&&U.updateLights(M.state.lightsArray),R.sortObjects===!0&&C.sort(Ne,Ye),Qt=fe.enabled===!1||fe.isPresenting===!1||fe.hasDepthSensing()===!1,Qt&&V.addToRenderList(C,A),this.info.autoReset===!0&&this.info.reset(),Mt===!0&&re.beginShadows();let K=M.state.shadowsArray;if(xe.render(K,A,q),Mt===!0&&re.endShadows(),(J&&L.hasRenderPass())===!1){let Le=C.opaque,Re=C.transmissive;if(M.setupLights(),q.isArrayCamera){let De=q.cameras;if(Re.length>0)for(let He=0,nt=De.length;He<nt;He++){let gt=De[He];Ai(Le,Re,A,gt)}Qt&&V.render(A);for(let He=0,nt=De.length;He<nt;He++){let gt=De[He];Qo(C,A,gt,gt.viewport)}}else Re.length>0&&Ai(Le,Re,A,q),Qt&&V.render(A),Qo(C,A,q)}X!==null&&O===0&&(Ze.updateMultisampleRenderTarget(X),Ze.updateRenderTargetMipmap(X)),J&&L.end(R),A.isScene===!0&&A.onAfterRender(R,A,q),we.resetDefaultState(),H=-1,Z=null,y.pop(),y.length>0?(M=y[y.length-1],Ze.setTextureUnits(M.state.textureUnits),Mt===!0&&re.setGlobalState(R.clippingPlanes,M.state.camera)):M=null,x.pop(),x.length>0?C=x[x.length-1]:C=null,U!==null&&U.renderEnd()};function fs(A,q,ne,J){if(A.visible===!1)return;if(A.layers.test(q.layers)){if(A.isGroup)ne=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(q);else if(A.isLight)M.pushLight(A),A.castShadow&&M.pushShadow(A);else if(A.isSprite){let Le=q.isArrayCamera?pt:$e;if(!A.frustumCulled||A.intersectsFrustum(Le)){J&&bt.setFromMatrixPosition(A.matrixWorld).applyMatrix4(Pt);let Re=pe.update(A),De=A.material;De.visible&&C.push(A,Re,De,ne,bt.z,null,q)}}else if(A.isMesh||A.isLine||A.isPoints){let Le=q.isArrayCamera?pt:$e;if(!A.frustumCulled||A.intersectsFrustum(Le)){let Re=pe.update(A),De=A.material;if(J&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),bt.copy(A.boundingSphere.center)):(Re.boundingSphere===null&&Re.computeBoundingSphere(),bt.copy(Re.boundingSphere.center)),bt.applyMatrix4(A.matrixWorld).applyMatrix4(Pt)),Array.isArray(De)){let He=Re.groups;for(let nt=0,gt=He.length;nt<gt;nt++){let Ge=He[nt],_t=De[Ge.materialIndex];_t&&_t.visible&&C.push(A,Re,_t,ne,bt.z,Ge,q)}}else De.visible&&C.push(A,Re,De,ne,bt.z,null,q)}}}let Ae=A.children;for(let Le=0,Re=Ae.length;Le<Re;Le++)fs(Ae[Le],q,ne,J)}function Qo(A,q,ne,J){let{opaque:K,transmissive:Ae,transparent:Le}=A;M.setupLightsView(ne),Mt===!0&&re.setGlobalState(R.clippingPlanes,ne),J&&Ee.viewport(te.copy(J)),K.length>0&&en(K,q,ne),Ae.length>0&&en(Ae,q,ne),Le.length>0&&en(Le,q,ne),Ee.buffers.depth.setTest(!0),Ee.buffers.depth.setMask(!0),Ee.buffers.color.setMask(!0),Ee.setPolygonOffset(!1)}function Ai(A,q,ne,J){if((ne.isScene===!0?ne.overrideMaterial:null)!==null)return;if(M.state.transmissionRenderTarget[J.id]===void 0){let Ge=Je.has("EXT_color_buffer_half_float")||Je.has("EXT_color_buffer_float");M.state.transmissionRenderTarget[J.id]=new _i(1,1,{generateMipmaps:!0,type:Ge?Wi:si,minFilter:Cs,samples:Math.max(4,lt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:St.workingColorSpace})}let Ae=M.state.transmissionRenderTarget[J.id],Le=J.viewport||te;Ae.setSize(Le.z*R.transmissionResolutionScale,Le.w*R.transmissionResolutionScale);let Re=R.getRenderTarget(),De=R.getActiveCubeFace(),He=R.getActiveMipmapLevel();R.setRenderTarget(Ae),R.getClearColor(Q),me=R.getClearAlpha(),me<1&&R.setClearColor(16777215,.5),R.clear(),Qt&&V.render(ne);let nt=R.toneMapping;R.toneMapping=os;let gt=J.viewport;if(J.viewport!==void 0&&(J.viewport=void 0),M.setupLightsView(J),Mt===!0&&re.setGlobalState(R.clippingPlanes,J),en(A,ne,J),Ze.updateMultisampleRenderTarget(Ae),Ze.updateRenderTargetMipmap(Ae),Je.has("WEBGL_multisampled_render_to_texture")===!1){let Ge=!1;for(let _t=0,Kt=q.length;_t<Kt;_t++){let Nt=q[_t],{object:Ut,geometry:yn,material:ke,group:cn}=Nt;if(ke.side===rs&&Ut.layers.test(J.layers)){let yt=ke.side;ke.side=ti,ke.needsUpdate=!0,on(Ut,ne,J,yn,ke,cn),ke.side=yt,ke.needsUpdate=!0,Ge=!0}}Ge===!0&&(Ze.updateMultisampleRenderTarget(Ae),Ze.updateRenderTargetMipmap(Ae))}R.setRenderTarget(Re,De,He),R.setClearColor(Q,me),gt!==void 0&&(J.viewport=gt),R.toneMapping=nt}function en(A,q,ne){let J=q.isScene===!0?q.overrideMaterial:null;for(let K=0,Ae=A.length;K<Ae;K++){let Le=A[K],{object:Re,geometry:De,group:He}=Le,nt=Le.material;nt.allowOverride===!0&&J!==null&&(nt=J),Re.layers.test(ne.layers)&&on(Re,q,ne,De,nt,He)}}function on(A,q,ne,J,K,Ae){U!==null&&K.isNodeMaterial&&U.setObject(A,K),A.onBeforeRender(R,q,ne,J,K,Ae),A.modelViewMatrix.multiplyMatrices(ne.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),K.onBeforeRender(R,q,ne,J,A,Ae),K.transparent===!0&&K.side===rs&&K.forceSinglePass===!1?(K.side=ti,K.needsUpdate=!0,R.renderBufferDirect(ne,q,J,K,A,Ae),K.side=ir,K.needsUpdate=!0,R.renderBufferDirect(ne,q,J,K,A,Ae),K.side=rs):R.renderBufferDirect(ne,q,J,K,A,Ae),A.onAfterRender(R,q,ne,J,K,Ae)}function an(A){let q=0;for(let ne of A)ne.texture!==null&&q++;return q}function Yi(A,q,ne){q.isScene!==!0&&(q=xn);let J=We.get(A),K=M.state.lights,Ae=M.state.shadowsArray,Le=K.state.version,Re=ce.getParameters(A,K.state,Ae,q,ne,M.state.lightProbeGridArray),De=ce.getProgramCacheKey(Re),He=J.programs;J.environment=A.isMeshStandardMaterial||A.isMeshLambertMaterial||A.isMeshPhongMaterial?q.environment:null,J.fog=q.fog;let nt=A.isMeshStandardMaterial||A.isMeshLambertMaterial&&!A.envMap||A.isMeshPhongMaterial&&!A.envMap;J.envMap=D.get(A.envMap||J.environment,nt),J.envMapRotation=J.environment!==null&&A.envMap===null?q.environmentRotation:A.envMapRotation,He===void 0&&(A.addEventListener("dispose",ut),He=new Map,J.programs=He,J.programVariants=new Map);let gt=He.get(De);if(gt!==void 0){if(J.currentProgram===gt&&J.lightsStateVersion===Le)return ea(A,Re),gt}else Re.uniforms=ce.getUniforms(A),U!==null&&A.isNodeMaterial&&U.build(A,ne,Re),A.onBeforeCompile(Re,R),gt=ce.acquireProgram(Re,De),He.set(De,gt),J.uniforms=Re.uniforms;let Ge=J.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(Ge.clippingPlanes=re.uniform),ea(A,Re),J.needsLights=Ns(A),J.lightsStateVersion=Le,J.needsLights&&(Ge.ambientLightColor.value=K.state.ambient,Ge.lightProbe.value=K.state.probe,Ge.sunLights.value=K.state.sun,Ge.sunLightShadows.value=K.state.sunShadow,Ge.directionalLights.value=K.state.directional,Ge.directionalLightShadows.value=K.state.directionalShadow,Ge.spotLights.value=K.state.spot,Ge.spotLightShadows.value=K.state.spotShadow,Ge.rectAreaLights.value=K.state.rectArea,Ge.ltc_1.value=K.state.rectAreaLTC1,Ge.ltc_2.value=K.state.rectAreaLTC2,Ge.pointLights.value=K.state.point,Ge.pointLightShadows.value=K.state.pointShadow,Ge.hemisphereLights.value=K.state.hemi,Ge.sunShadowMatrix.value=K.state.sunShadowMatrix,Ge.sunShadowCascade.value=K.state.sunShadowCascade,Ge.directionalShadowMatrix.value=K.state.directionalShadowMatrix,Ge.spotLightMatrix.value=K.state.spotLightMatrix,Ge.spotLightMap.value=K.state.spotLightMap,Ge.pointShadowMatrix.value=K.state.pointShadowMatrix),J.numLightProbeGrids=an(M.state.lightProbeGridArray),J.currentProgram=gt,J.uniformsList=null,gt}function oi(A,q,ne,J,K){let Ae=We.get(A),Le=Ae.currentProgram.id+","+J+","+K,Re=Ae.programVariants.get(Le);return Re===void 0?(Re=Yi(A,q,ne),Ae.programVariants.set(Le,Re)):(Ae.currentProgram=Re,Ae.uniformsList=null,Ae.outputColorSpace=J,Ae.toneMapping=K),Re}function Ds(A){if(A.uniformsList===null){let q=A.currentProgram.getUniforms();A.uniformsList=$o.seqWithValue(q.seq,A.uniforms)}return A.uniformsList}function ea(A,q){let ne=We.get(A);ne.outputColorSpace=q.outputColorSpace,ne.batching=q.batching,ne.batchingColor=q.batchingColor,ne.instancing=q.instancing,ne.instancingColor=q.instancingColor,ne.instancingMorph=q.instancingMorph,ne.skinning=q.skinning,ne.morphTargets=q.morphTargets,ne.morphNormals=q.morphNormals,ne.morphColors=q.morphColors,ne.morphTargetsCount=q.morphTargetsCount,ne.numClippingPlanes=q.numClippingPlanes,ne.numIntersection=q.numClipIntersection,ne.vertexAlphas=q.vertexAlphas,ne.vertexTangents=q.vertexTangents,ne.toneMapping=q.toneMapping}function ta(A,q,ne,J,K){q.isScene!==!0&&(q=xn),Ze.resetTextureUnits();let Ae=q.fog,Le=J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial?q.environment:null,Re=X===null?R.outputColorSpace:X.isXRRenderTarget===!0?X.texture.colorSpace:St.workingColorSpace,De=J.isMeshStandardMaterial||J.isMeshLambertMaterial&&!J.envMap||J.isMeshPhongMaterial&&!J.envMap,He=D.get(J.envMap||Le,De),nt=J.vertexColors===!0&&!!ne.attributes.color&&ne.attributes.color.itemSize===4,gt=!!ne.attributes.tangent&&(!!J.normalMap||J.anisotropy>0),Ge=!!ne.morphAttributes.position,_t=!!ne.morphAttributes.normal,Kt=!!ne.morphAttributes.color,Nt=os;J.toneMapped&&(X===null||X.isXRRenderTarget===!0)&&(Nt=R.toneMapping);let Ut=ne.morphAttributes.position||ne.morphAttributes.normal||ne.morphAttributes.color,yn=Ut!==void 0?Ut.length:0,ke=We.get(J),cn=M.state.lights;if(Mt===!0&&(jt===!0||A!==Z)){let Ft=A===Z&&J.id===H;re.setState(J,A,Ft)}let yt=!1,ps=!1;J.version===ke.__version?ke.needsLights&&ke.lightsStateVersion!==cn.state.version||K.isBatchedMesh&&ke.batching===!1||!K.isBatchedMesh&&ke.batching===!0||K.isBatchedMesh&&ke.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&ke.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&ke.instancing===!1||!K.isInstancedMesh&&ke.instancing===!0||K.isSkinnedMesh&&ke.skinning===!1||!K.isSkinnedMesh&&ke.skinning===!0||K.isInstancedMesh&&ke.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&ke.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&ke.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&ke.instancingMorph===!1&&K.morphTexture!==null||ke.envMap!==He||J.fog===!0&&ke.fog!==Ae||ke.numClippingPlanes!==void 0&&(ke.numClippingPlanes!==re.numPlanes||ke.numIntersection!==re.numIntersection)||ke.vertexAlphas!==nt||ke.vertexTangents!==gt||ke.morphTargets!==Ge||ke.morphNormals!==_t||ke.morphColors!==Kt||ke.morphTargetsCount!==yn||ke.numLightProbeGrids!==an(M.state.lightProbeGridArray)?yt=!0:(ke.outputColorSpace!==Re||ke.toneMapping!==Nt)&&(ps=!0):(yt=!0,ke.__version=J.version);let hn=ke.currentProgram;(yt===!0||ps===!0)&&(hn=ps===!0?oi(J,q,K,Re,Nt):Yi(J,q,K),U&&J.isNodeMaterial&&U.onUpdateProgram(J,hn,ke));let qr=!1,$i=!1,ms=!1,dt=hn.getUniforms(),tn=ke.uniforms;if(Ee.useProgram(hn.program)&&(qr=!0,$i=!0,ms=!0),J.id!==H&&(H=J.id,$i=!0),qr||Z!==A){Ee.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),dt.setValue(G,"projectionMatrix",A.projectionMatrix),dt.setValue(G,"viewMatrix",A.matrixWorldInverse);let un=dt.map.cameraPosition;un!==void 0&&un.setValue(G,rn.setFromMatrixPosition(A.matrixWorld)),lt.logarithmicDepthBuffer&&dt.setValue(G,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),(J.isMeshPhongMaterial||J.isMeshToonMaterial||J.isMeshLambertMaterial||J.isMeshBasicMaterial||J.isMeshStandardMaterial||J.isShaderMaterial)&&dt.setValue(G,"isOrthographic",A.isOrthographicCamera===!0),Z!==A&&(Z=A,$i=!0,ms=!0)}if(ke.needsLights&&(cn.state.sunShadowMap.length>0&&dt.setValue(G,"sunShadowMap",cn.state.sunShadowMap,Ze),cn.state.directionalShadowMap.length>0&&dt.setValue(G,"directionalShadowMap",cn.state.directionalShadowMap,Ze),cn.state.spotShadowMap.length>0&&dt.setValue(G,"spotShadowMap",cn.state.spotShadowMap,Ze),cn.state.pointShadowMap.length>0&&dt.setValue(G,"pointShadowMap",cn.state.pointShadowMap,Ze)),K.isSkinnedMesh){dt.setOptional(G,K,"bindMatrix"),dt.setOptional(G,K,"bindMatrixInverse");let Ft=K.skeleton;Ft&&(Ft.boneTexture===null&&Ft.computeBoneTexture(),dt.setValue(G,"boneTexture",Ft.boneTexture,Ze))}K.isBatchedMesh&&(dt.setOptional(G,K,"batchingTexture"),dt.setValue(G,"batchingTexture",K._matricesTexture,Ze),dt.setOptional(G,K,"batchingIdTexture"),dt.setValue(G,"batchingIdTexture",K._indirectTexture,Ze),dt.setOptional(G,K,"batchingColorTexture"),K._colorsTexture!==null&&dt.setValue(G,"batchingColorTexture",K._colorsTexture,Ze));let Hn=ne.morphAttributes;if((Hn.position!==void 0||Hn.normal!==void 0||Hn.color!==void 0)&&ae.update(K,ne,hn),($i||ke.receiveShadow!==K.receiveShadow)&&(ke.receiveShadow=K.receiveShadow,dt.setValue(G,"receiveShadow",K.receiveShadow)),(J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial)&&J.envMap===null&&q.environment!==null&&(tn.envMapIntensity.value=q.environmentIntensity),tn.dfgLUT!==void 0&&(tn.dfgLUT.value=KE()),$i){if(dt.setValue(G,"toneMappingExposure",R.toneMappingExposure),ke.needsLights&&Hr(tn,ms),Ae&&J.fog===!0&&ve.refreshFogUniforms(tn,Ae),ve.refreshMaterialUniforms(tn,J,de,oe,M.state.transmissionRenderTarget[A.id]),ke.needsLights&&ke.numLightProbeGrids>0){let Ft=b,un=0;for(let Fn of M.state.lightProbeGridArray)Fn.texture!==null&&(Ft.textures[un]=Fn.texture,Ft.min[un]=Fn.boundingBox.min,Ft.max[un]=Fn.boundingBox.max,Ft.resolution[un]=Fn.resolution,un++);for(let Fn in Ft)Ft[Fn].length=un;tn.probesSH.value=Ft.textures,tn.probesMin.value=Ft.min,tn.probesMax.value=Ft.max,tn.probesResolution.value=Ft.resolution}$o.upload(G,Ds(ke),tn,Ze)}if(J.isShaderMaterial&&J.uniformsNeedUpdate===!0&&($o.upload(G,Ds(ke),tn,Ze),J.uniformsNeedUpdate=!1),J.isSpriteMaterial&&dt.setValue(G,"center",K.center),dt.setValue(G,"modelViewMatrix",K.modelViewMatrix),dt.setValue(G,"normalMatrix",K.normalMatrix),dt.setValue(G,"modelMatrix",K.matrixWorld),J.uniformsGroups!==void 0){let Ft=J.uniformsGroups;for(let un=0,Fn=Ft.length;un<Fn;un++){let Sl=Ft[un];qe.update(Sl,hn),qe.bind(Sl,hn)}}return hn}function Hr(A,q){A.ambientLightColor.needsUpdate=q,A.lightProbe.needsUpdate=q,A.sunLights.needsUpdate=q,A.sunLightShadows.needsUpdate=q,A.directionalLights.needsUpdate=q,A.directionalLightShadows.needsUpdate=q,A.pointLights.needsUpdate=q,A.pointLightShadows.needsUpdate=q,A.spotLights.needsUpdate=q,A.spotLightShadows.needsUpdate=q,A.rectAreaLights.needsUpdate=q,A.hemisphereLights.needsUpdate=q}function Ns(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return z},this.getActiveMipmapLevel=function(){return O},this.getRenderTarget=function(){return X},this.setRenderTargetTextures=function(A,q,ne){let J=We.get(A);J.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,J.__autoAllocateDepthBuffer===!1&&(J.__useRenderToTexture=!1),We.get(A.texture).__webglTexture=q,We.get(A.depthTexture).__webglTexture=J.__autoAllocateDepthBuffer?void 0:ne,J.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,q){let ne=We.get(A);ne.__webglFramebuffer=q,ne.__useDefaultFramebuffer=q===void 0},this.setRenderTarget=function(A,q=0,ne=0){X=A,z=q,O=ne;let J=null,K=!1,Ae=!1;if(A){let Re=We.get(A);if(Re.__useDefaultFramebuffer!==void 0){Ee.bindFramebuffer(G.FRAMEBUFFER,Re.__webglFramebuffer),te.copy(A.viewport),le.copy(A.scissor),he=A.scissorTest,Ee.viewport(te),Ee.scissor(le),Ee.setScissorTest(he),H=-1;return}else if(Re.__webglFramebuffer===void 0)Ze.setupRenderTarget(A);else if(Re.__hasExternalTextures)Ze.rebindTextures(A,We.get(A.texture).__webglTexture,We.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){let nt=A.depthTexture;if(Re.__boundDepthTexture!==nt){if(nt!==null&&We.has(nt)&&(A.width!==nt.image.width||A.height!==nt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ze.setupDepthRenderbuffer(A)}}let De=A.texture;(De.isData3DTexture||De.isDataArrayTexture||De.isCompressedArrayTexture)&&(Ae=!0);let He=We.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(He[q])?J=He[q][ne]:J=He[q],K=!0):A.samples>0&&Ze.useMultisampledRTT(A)===!1?J=We.get(A).__webglMultisampledFramebuffer:Array.isArray(He)?J=He[ne]:J=He,te.copy(A.viewport),le.copy(A.scissor),he=A.scissorTest}else te.copy(Be).multiplyScalar(de).floor(),le.copy(st).multiplyScalar(de).floor(),he=at;if(ne!==0&&(J=k),Ee.bindFramebuffer(G.FRAMEBUFFER,J)&&Ee.drawBuffers(A,J),Ee.viewport(te),Ee.scissor(le),Ee.setScissorTest(he),K){let Re=We.get(A.texture);G.framebufferTexture2D(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_CUBE_MAP_POSITIVE_X+q,Re.__webglTexture,ne)}else if(Ae){let Re=q;for(let De=0;De<A.textures.length;De++){let He=We.get(A.textures[De]);G.framebufferTextureLayer(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0+De,He.__webglTexture,ne,Re)}}else if(A!==null&&ne!==0){let Re=We.get(A.texture);G.framebufferTexture2D(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,Re.__webglTexture,ne)}H=-1};function Wr(A){let q=We.get(A);return(q.__readFormat!==A.format||q.__readType!==A.type)&&(q.__readFormat=A.format,q.__readType=A.type,q.__formatReadable=lt.textureFormatReadable(A.format),q.__typeReadable=lt.textureTypeReadable(A.type)),q}this.readRenderTargetPixels=function(A,q,ne,J,K,Ae,Le,Re=0){if(!(A&&A.isWebGLRenderTarget)){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let De=We.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Le!==void 0&&(De=De[Le],Array.isArray(De)&&(De=De[0])),De){Ee.bindFramebuffer(G.FRAMEBUFFER,De);try{let He=A.textures[Re],nt=He.format,gt=He.type;A.textures.length>1&&G.readBuffer(G.COLOR_ATTACHMENT0+Re);let Ge=Wr(He);if(Ge.__formatReadable===!1){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ge.__typeReadable===!1){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}q>=0&&q<=A.width-J&&ne>=0&&ne<=A.height-K&&G.readPixels(q,ne,J,K,ye.convert(nt),ye.convert(gt),Ae)}finally{let He=X!==null?We.get(X).__webglFramebuffer:null;Ee.bindFramebuffer(G.FRAMEBUFFER,He)}}},this.readRenderTargetPixelsAsync=async function(A,q,ne,J,K,Ae,Le,Re=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let De=We.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Le!==void 0&&(De=De[Le],Array.isArray(De)&&(De=De[0])),De)if(q>=0&&q<=A.width-J&&ne>=0&&ne<=A.height-K){Ee.bindFramebuffer(G.FRAMEBUFFER,De);let He=A.textures[Re],nt=He.format,gt=He.type;A.textures.length>1&&G.readBuffer(G.COLOR_ATTACHMENT0+Re);let Ge=Wr(He);if(Ge.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ge.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let _t=G.createBuffer();G.bindBuffer(G.PIXEL_PACK_BUFFER,_t),G.bufferData(G.PIXEL_PACK_BUFFER,Ae.byteLength,G.STREAM_READ),G.readPixels(q,ne,J,K,ye.convert(nt),ye.convert(gt),0),G.bindBuffer(G.PIXEL_PACK_BUFFER,null);let Kt=X!==null?We.get(X).__webglFramebuffer:null;Ee.bindFramebuffer(G.FRAMEBUFFER,Kt);let Nt=G.fenceSync(G.SYNC_GPU_COMMANDS_COMPLETE,0);return G.flush(),await t_(G,Nt,4),G.bindBuffer(G.PIXEL_PACK_BUFFER,_t),G.getBufferSubData(G.PIXEL_PACK_BUFFER,0,Ae),G.bindBuffer(G.PIXEL_PACK_BUFFER,null),G.deleteBuffer(_t),G.deleteSync(Nt),Ae}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,q=null,ne=0){let J=Math.pow(2,-ne),K=Math.floor(A.image.width*J),Ae=Math.floor(A.image.height*J),Le=q!==null?q.x:0,Re=q!==null?q.y:0;Ze.setTexture2D(A,0),G.copyTexSubImage2D(G.TEXTURE_2D,ne,0,0,Le,Re,K,Ae),Ee.unbindTexture()},this.copyTextureToTexture=function(A,q,ne=null,J=null,K=0,Ae=0){let Le,Re,De,He,nt,gt,Ge,_t,Kt,Nt=A.isCompressedTexture?A.mipmaps[Ae]:A.image;if(ne!==null)Le=ne.max.x-ne.min.x,Re=ne.max.y-ne.min.y,De=ne.isBox3?ne.max.z-ne.min.z:1,He=ne.min.x,nt=ne.min.y,gt=ne.isBox3?ne.min.z:0;else{let dt=Math.pow(2,-K);Le=Math.floor(Nt.width*dt),Re=Math.floor(Nt.height*dt),A.isDataArrayTexture?De=Nt.depth:A.isData3DTexture?De=Math.floor(Nt.depth*dt):De=1,He=0,nt=0,gt=0}J!==null?(Ge=J.x,_t=J.y,Kt=J.z):(Ge=0,_t=0,Kt=0);let Ut=ye.convert(q.format),yn=ye.convert(q.type),ke;q.isData3DTexture?(Ze.setTexture3D(q,0),ke=G.TEXTURE_3D):q.isDataArrayTexture||q.isCompressedArrayTexture?(Ze.setTexture2DArray(q,0),ke=G.TEXTURE_2D_ARRAY):(Ze.setTexture2D(q,0),ke=G.TEXTURE_2D),Ee.activeTexture(G.TEXTURE0),Ee.pixelStorei(G.UNPACK_FLIP_Y_WEBGL,q.flipY),Ee.pixelStorei(G.UNPACK_PREMULTIPLY_ALPHA_WEBGL,q.premultiplyAlpha),Ee.pixelStorei(G.UNPACK_ALIGNMENT,q.unpackAlignment);let cn=Ee.getParameter(G.UNPACK_ROW_LENGTH),yt=Ee.getParameter(G.UNPACK_IMAGE_HEIGHT),ps=Ee.getParameter(G.UNPACK_SKIP_PIXELS),hn=Ee.getParameter(G.UNPACK_SKIP_ROWS),qr=Ee.getParameter(G.UNPACK_SKIP_IMAGES);Ee.pixelStorei(G.UNPACK_ROW_LENGTH,Nt.width),Ee.pixelStorei(G.UNPACK_IMAGE_HEIGHT,Nt.height),Ee.pixelStorei(G.UNPACK_SKIP_PIXELS,He),Ee.pixelStorei(G.UNPACK_SKIP_ROWS,nt),Ee.pixelStorei(G.UNPACK_SKIP_IMAGES,gt);let $i=A.isDataArrayTexture||A.isData3DTexture,ms=q.isDataArrayTexture||q.isData3DTexture;if(A.isDepthTexture){let dt=We.get(A),tn=We.get(q),Hn=We.get(dt.__renderTarget),Ft=We.get(tn.__renderTarget);Ee.bindFramebuffer(G.READ_FRAMEBUFFER,Hn.__webglFramebuffer),Ee.bindFramebuffer(G.DRAW_FRAMEBUFFER,Ft.__webglFramebuffer);for(let un=0;un<De;un++)$i&&(G.framebufferTextureLayer(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,We.get(A).__webglTexture,K,gt+un),G.framebufferTextureLayer(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,We.get(q).__webglTexture,Ae,Kt+un)),G.blitFramebuffer(He,nt,He+Le,nt+Re,Ge,_t,Ge+Le,_t+Re,G.DEPTH_BUFFER_BIT,G.NEAREST);Ee.bindFramebuffer(G.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(G.DRAW_FRAMEBUFFER,null)}else if(K!==0||A.isRenderTargetTexture||We.has(A)){let dt=We.get(A),tn=We.get(q);Ee.bindFramebuffer(G.READ_FRAMEBUFFER,E),Ee.bindFramebuffer(G.DRAW_FRAMEBUFFER,N);for(let Hn=0;Hn<De;Hn++)$i?G.framebufferTextureLayer(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,dt.__webglTexture,K,gt+Hn):G.framebufferTexture2D(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,dt.__webglTexture,K),ms?G.framebufferTextureLayer(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,tn.__webglTexture,Ae,Kt+Hn):G.framebufferTexture2D(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,tn.__webglTexture,Ae),K!==0?G.blitFramebuffer(He,nt,He+Le,nt+Re,Ge,_t,Ge+Le,_t+Re,G.COLOR_BUFFER_BIT,G.NEAREST):ms?G.copyTexSubImage3D(ke,Ae,Ge,_t,Kt+Hn,He,nt,Le,Re):G.copyTexSubImage2D(ke,Ae,Ge,_t,He,nt,Le,Re);Ee.bindFramebuffer(G.READ_FRAMEBUFFER,null),Ee.bindFramebuffer(G.DRAW_FRAMEBUFFER,null)}else ms?A.isDataTexture||A.isData3DTexture?G.texSubImage3D(ke,Ae,Ge,_t,Kt,Le,Re,De,Ut,yn,Nt.data):q.isCompressedArrayTexture?G.compressedTexSubImage3D(ke,Ae,Ge,_t,Kt,Le,Re,De,Ut,Nt.data):G.texSubImage3D(ke,Ae,Ge,_t,Kt,Le,Re,De,Ut,yn,Nt):A.isDataTexture?G.texSubImage2D(G.TEXTURE_2D,Ae,Ge,_t,Le,Re,Ut,yn,Nt.data):A.isCompressedTexture?G.compressedTexSubImage2D(G.TEXTURE_2D,Ae,Ge,_t,Nt.width,Nt.height,Ut,Nt.data):G.texSubImage2D(G.TEXTURE_2D,Ae,Ge,_t,Le,Re,Ut,yn,Nt);Ee.pixelStorei(G.UNPACK_ROW_LENGTH,cn),Ee.pixelStorei(G.UNPACK_IMAGE_HEIGHT,yt),Ee.pixelStorei(G.UNPACK_SKIP_PIXELS,ps),Ee.pixelStorei(G.UNPACK_SKIP_ROWS,hn),Ee.pixelStorei(G.UNPACK_SKIP_IMAGES,qr),Ae===0&&q.generateMipmaps===!0&&q.mipmapsAutoUpdate===!0&&G.generateMipmap(ke),Ee.unbindTexture()},this.initRenderTarget=function(A){We.get(A).__webglFramebuffer===void 0&&Ze.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?Ze.setTextureCube(A,0):A.isData3DTexture?Ze.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?Ze.setTexture2DArray(A,0):Ze.setTexture2D(A,0),Ee.unbindTexture()},this.resetState=function(){z=0,O=0,X=null,Ee.reset(),we.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ei}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=St._getDrawingBufferColorSpace(e),t.unpackColorSpace=St._getUnpackColorSpace()}};var B_=new xi,tu=new Y,jo=class extends el{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let e=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],t=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],i=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(i),this.setAttribute("position",new Ht(e,3)),this.setAttribute("uv",new Ht(t,2))}applyMatrix4(e){let t=this.attributes.instanceStart,i=this.attributes.instanceEnd;return t!==void 0&&(t.applyMatrix4(e),i.applyMatrix4(e),t.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let i=new er(t,6,1);return this.setAttribute("instanceStart",new Vi(i,3,0)),this.setAttribute("instanceEnd",new Vi(i,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let i=new er(t,6,1);return this.setAttribute("instanceColorStart",new Vi(i,3,0)),this.setAttribute("instanceColorEnd",new Vi(i,3,3)),this}fromWireframeGeometry(e){return this.setPositions(e.attributes.position.array),this}fromEdgesGeometry(e){return this.setPositions(e.attributes.position.array),this}fromMesh(e){return this.fromWireframeGeometry(new Xa(e.geometry)),this}fromLineSegments(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new xi);let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;e!==void 0&&t!==void 0&&(this.boundingBox.setFromBufferAttribute(e),B_.setFromBufferAttribute(t),this.boundingBox.union(B_))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new zi),this.boundingBox===null&&this.computeBoundingBox();let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;if(e!==void 0&&t!==void 0){let i=this.boundingSphere.center;this.boundingBox.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)tu.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(tu)),tu.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(tu));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};Ie.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Ke},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};ni.line={uniforms:fl.merge([Ie.common,Ie.fog,Ie.line]),vertexShader:`
		#include <common>
		#include <color_pars_vertex>
		#include <fog_pars_vertex>
		#include <logdepthbuf_pars_vertex>
		#include <clipping_planes_pars_vertex>

		uniform float linewidth;
		uniform vec2 resolution;

		attribute vec3 instanceStart;
		attribute vec3 instanceEnd;

		attribute vec3 instanceColorStart;
		attribute vec3 instanceColorEnd;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#ifdef USE_DASH

			uniform float dashScale;
			attribute float instanceDistanceStart;
			attribute float instanceDistanceEnd;
			varying float vLineDistance;

		#endif

		float trimSegmentAlpha( const in vec4 start, const in vec4 end ) {

			// compute the interpolation factor needed to trim the segment so it terminates
			// between the camera plane and the near plane

			// conservative estimate of the near plane
			float a = projectionMatrix[ 2 ][ 2 ]; // 3nd entry in 3th column
			float b = projectionMatrix[ 3 ][ 2 ]; // 3nd entry in 4th column

			// we need different nearEstimate formula for reversed and default depth buffer
			// a is positive with a reversed depth buffer so it can be used for controlling the code flow
			float nearEstimate = ( a > 0.0 ) ? ( - b / ( a + 1.0 ) ) : ( - 0.5 * b / a );

			return ( nearEstimate - start.z ) / ( end.z - start.z );

		}

		void main() {

			#ifdef USE_COLOR

				vColor.xyz = ( position.y < 0.5 ) ? instanceColorStart : instanceColorEnd;

			#endif

			float aspect = resolution.x / resolution.y;

			// camera space
			vec4 start = modelViewMatrix * vec4( instanceStart, 1.0 );
			vec4 end = modelViewMatrix * vec4( instanceEnd, 1.0 );

			#ifdef USE_DASH

				float lineDistanceStart = dashScale * instanceDistanceStart;
				float lineDistanceEnd = dashScale * instanceDistanceEnd;

			#endif

			#ifdef WORLD_UNITS

				worldStart = start.xyz;
				worldEnd = end.xyz;

			#else

				vUv = uv;

			#endif

			// special case for perspective projection, and segments that terminate either in, or behind, the camera plane
			// clearly the gpu firmware has a way of addressing this issue when projecting into ndc space
			// but we need to perform ndc-space calculations in the shader, so we must address this issue directly
			// perhaps there is a more elegant solution -- WestLangley

			bool perspective = ( projectionMatrix[ 2 ][ 3 ] == - 1.0 ); // 4th entry in the 3rd column

			if ( perspective ) {

				if ( start.z < 0.0 && end.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( start, end );
					end.xyz = mix( start.xyz, end.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceEnd = mix( lineDistanceStart, lineDistanceEnd, alpha );

					#endif

				} else if ( end.z < 0.0 && start.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( end, start );
					start.xyz = mix( end.xyz, start.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceStart = mix( lineDistanceEnd, lineDistanceStart, alpha );

					#endif

				}

			}

			#ifdef USE_DASH

				vLineDistance = ( position.y < 0.5 ) ? lineDistanceStart : lineDistanceEnd;
				vUv = uv;

			#endif

			// clip space
			vec4 clipStart = projectionMatrix * start;
			vec4 clipEnd = projectionMatrix * end;

			// ndc space
			vec3 ndcStart = clipStart.xyz / clipStart.w;
			vec3 ndcEnd = clipEnd.xyz / clipEnd.w;

			// direction
			vec2 dir = ndcEnd.xy - ndcStart.xy;

			// account for clip-space aspect ratio
			dir.x *= aspect;
			dir = normalize( dir );

			#ifdef WORLD_UNITS

				vec3 worldDir = normalize( end.xyz - start.xyz );
				vec3 tmpFwd = perspective ? normalize( mix( start.xyz, end.xyz, 0.5 ) ) : vec3( 0.0, 0.0, - 1.0 );
				vec3 worldUp = normalize( cross( worldDir, tmpFwd ) );
				vec3 worldFwd = cross( worldDir, worldUp );
				worldPos = position.y < 0.5 ? start: end;

				// height offset
				float hw = linewidth * 0.5;
				worldPos.xyz += position.x < 0.0 ? hw * worldUp : - hw * worldUp;

				// don't extend the line if we're rendering dashes because we
				// won't be rendering the endcaps
				#ifndef USE_DASH

					// cap extension
					worldPos.xyz += position.y < 0.5 ? - hw * worldDir : hw * worldDir;

					// add width to the box
					worldPos.xyz += worldFwd * hw;

					// endcaps
					if ( position.y > 1.0 || position.y < 0.0 ) {

						worldPos.xyz -= worldFwd * 2.0 * hw;

					}

				#endif

				// project the worldpos
				vec4 clip = projectionMatrix * worldPos;

				// shift the depth of the projected points so the line
				// segments overlap neatly
				vec3 clipPose = ( position.y < 0.5 ) ? ndcStart : ndcEnd;

				// only shift the depth of vertices in front of the camera (#35137)
				if ( clip.w > 0.0 ) clip.z = clipPose.z * clip.w;

			#else

				vec2 offset = vec2( dir.y, - dir.x );
				// undo aspect ratio adjustment
				dir.x /= aspect;
				offset.x /= aspect;

				// sign flip
				if ( position.x < 0.0 ) offset *= - 1.0;

				// endcaps
				if ( position.y < 0.0 ) {

					offset += - dir;

				} else if ( position.y > 1.0 ) {

					offset += dir;

				}

				// adjust for linewidth
				offset *= linewidth;

				// adjust for clip-space to screen-space conversion // maybe resolution should be based on viewport ...
				offset /= resolution.y;

				// select end
				vec4 clip = ( position.y < 0.5 ) ? clipStart : clipEnd;

				// back to clip space
				offset *= clip.w;

				clip.xy += offset;

			#endif

			gl_Position = clip;

			vec4 mvPosition = ( position.y < 0.5 ) ? start : end; // this is an approximation

			#include <logdepthbuf_vertex>
			#include <clipping_planes_vertex>
			#include <fog_vertex>

		}
		`,fragmentShader:`
		uniform vec3 diffuse;
		uniform float opacity;
		uniform float linewidth;

		#ifdef USE_DASH

			uniform float dashOffset;
			uniform float dashSize;
			uniform float gapSize;

		#endif

		varying float vLineDistance;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#include <common>
		#include <color_pars_fragment>
		#include <fog_pars_fragment>
		#include <logdepthbuf_pars_fragment>
		#include <clipping_planes_pars_fragment>

		vec2 closestLineToLine(vec3 p1, vec3 p2, vec3 p3, vec3 p4) {

			float mua;
			float mub;

			vec3 p13 = p1 - p3;
			vec3 p43 = p4 - p3;

			vec3 p21 = p2 - p1;

			float d1343 = dot( p13, p43 );
			float d4321 = dot( p43, p21 );
			float d1321 = dot( p13, p21 );
			float d4343 = dot( p43, p43 );
			float d2121 = dot( p21, p21 );

			float denom = d2121 * d4343 - d4321 * d4321;

			float numer = d1343 * d4321 - d1321 * d4343;

			mua = numer / denom;
			mua = clamp( mua, 0.0, 1.0 );
			mub = ( d1343 + d4321 * ( mua ) ) / d4343;
			mub = clamp( mub, 0.0, 1.0 );

			return vec2( mua, mub );

		}

		void main() {

			float alpha = opacity;
			vec4 diffuseColor = vec4( diffuse, alpha );

			#include <clipping_planes_fragment>

			#ifdef USE_DASH

				if ( vUv.y < - 1.0 || vUv.y > 1.0 ) discard; // discard endcaps

				if ( mod( vLineDistance + dashOffset, dashSize + gapSize ) > dashSize ) discard; // todo - FIX

			#endif

			#ifdef WORLD_UNITS

				float len;

				if ( isOrthographic ) {

					// View rays are parallel to the z axis so the distance reduces to camera-space XY
					vec2 lineDir = worldEnd.xy - worldStart.xy;
					float t = clamp( dot( worldPos.xy - worldStart.xy, lineDir ) / dot( lineDir, lineDir ), 0.0, 1.0 );
					len = length( worldStart.xy + lineDir * t - worldPos.xy );

				} else {

					// Find the closest points on the view ray and the line segment
					vec3 rayEnd = normalize( worldPos.xyz ) * 1e5;
					vec3 lineDir = worldEnd - worldStart;
					vec2 params = closestLineToLine( worldStart, worldEnd, vec3( 0.0, 0.0, 0.0 ), rayEnd );

					vec3 p1 = worldStart + lineDir * params.x;
					vec3 p2 = rayEnd * params.y;
					vec3 delta = p1 - p2;
					len = length( delta );

				}

				float norm = len / linewidth;

				#ifndef USE_DASH

					#ifdef USE_ALPHA_TO_COVERAGE

						float dnorm = fwidth( norm );
						alpha = 1.0 - smoothstep( 0.5 - dnorm, 0.5 + dnorm, norm );

					#else

						if ( norm > 0.5 ) {

							discard;

						}

					#endif

				#endif

			#else

				#ifdef USE_ALPHA_TO_COVERAGE

					// artifacts appear on some hardware if a derivative is taken within a conditional
					float a = vUv.x;
					float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
					float len2 = a * a + b * b;
					float dlen = fwidth( len2 );

					if ( abs( vUv.y ) > 1.0 ) {

						alpha = 1.0 - smoothstep( 1.0 - dlen, 1.0 + dlen, len2 );

					}

				#else

					if ( abs( vUv.y ) > 1.0 ) {

						float a = vUv.x;
						float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
						float len2 = a * a + b * b;

						if ( len2 > 1.0 ) discard;

					}

				#endif

			#endif

			#include <logdepthbuf_fragment>
			#include <color_fragment>

			gl_FragColor = vec4( diffuseColor.rgb, alpha );

			#include <tonemapping_fragment>
			#include <colorspace_fragment>
			#include <fog_fragment>
			#include <premultiplied_alpha_fragment>

		}
		`};var or=class extends Ti{constructor(e){super({type:"LineMaterial",uniforms:fl.clone(ni.line.uniforms),vertexShader:ni.line.vertexShader,fragmentShader:ni.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(e)}get color(){return this.uniforms.diffuse.value}set color(e){this.uniforms.diffuse.value=e}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(e){e===!0!==this.worldUnits&&(this.needsUpdate=!0),e===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(e){this.uniforms.linewidth&&(this.uniforms.linewidth.value=e)}get dashed(){return"USE_DASH"in this.defines}set dashed(e){e===!0!==this.dashed&&(this.needsUpdate=!0),e===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(e){this.uniforms.dashScale.value=e}get dashSize(){return this.uniforms.dashSize.value}set dashSize(e){this.uniforms.dashSize.value=e}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(e){this.uniforms.dashOffset.value=e}get gapSize(){return this.uniforms.gapSize.value}set gapSize(e){this.uniforms.gapSize.value=e}get opacity(){return this.uniforms.opacity.value}set opacity(e){this.uniforms&&(this.uniforms.opacity.value=e)}get resolution(){return this.uniforms.resolution.value}set resolution(e){this.uniforms.resolution.value.copy(e)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(e){this.defines&&(e===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),e===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var Yf=new Dt,k_=new Y,z_=new Y,Dn=new Dt,Nn=new Dt,ls=new Dt,$f=new Y,Zf=new Bt,Un=new tl,V_=new Y,nu=new xi,iu=new zi,cs=new Dt,hs,Br;function G_(n,e,t){return cs.set(0,0,-e,1).applyMatrix4(n.projectionMatrix),cs.multiplyScalar(1/cs.w),cs.x=Br/t.width,cs.y=Br/t.height,cs.applyMatrix4(n.projectionMatrixInverse),cs.multiplyScalar(1/cs.w),Math.abs(Math.max(cs.x,cs.y))}function QE(n,e){let t=n.matrixWorld,i=n.geometry,s=i.attributes.instanceStart,r=i.attributes.instanceEnd,o=Math.min(i.instanceCount,s.count);for(let a=0,l=o;a<l;a++){Un.start.fromBufferAttribute(s,a),Un.end.fromBufferAttribute(r,a),Un.applyMatrix4(t);let c=new Y,u=new Y;hs.distanceSqToSegment(Un.start,Un.end,u,c),u.distanceTo(c)<Br*.5&&e.push({point:u,pointOnLine:c,distance:hs.origin.distanceTo(u),object:n,face:null,faceIndex:a,uv:null,uv1:null})}}function eT(n,e,t){let i=e.projectionMatrix,r=n.material.resolution,o=n.matrixWorld,a=n.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,u=Math.min(a.instanceCount,l.count),d=-e.near;hs.at(1,ls),ls.w=1,ls.applyMatrix4(e.matrixWorldInverse),ls.applyMatrix4(i),ls.multiplyScalar(1/ls.w),ls.x*=r.x/2,ls.y*=r.y/2,ls.z=0,$f.copy(ls),Zf.multiplyMatrices(e.matrixWorldInverse,o);for(let h=0,m=u;h<m;h++){if(Dn.fromBufferAttribute(l,h),Nn.fromBufferAttribute(c,h),Dn.w=1,Nn.w=1,Dn.applyMatrix4(Zf),Nn.applyMatrix4(Zf),Dn.z>d&&Nn.z>d)continue;if(Dn.z>d){let P=Dn.z-Nn.z,b=(Dn.z-d)/P;Dn.lerp(Nn,b)}else if(Nn.z>d){let P=Nn.z-Dn.z,b=(Nn.z-d)/P;Nn.lerp(Dn,b)}Dn.applyMatrix4(i),Nn.applyMatrix4(i),Dn.multiplyScalar(1/Dn.w),Nn.multiplyScalar(1/Nn.w),Dn.x*=r.x/2,Dn.y*=r.y/2,Nn.x*=r.x/2,Nn.y*=r.y/2,Un.start.copy(Dn),Un.start.z=0,Un.end.copy(Nn),Un.end.z=0;let _=Un.closestPointToPointParameter($f,!0);Un.at(_,V_);let f=dl.lerp(Dn.z,Nn.z,_),p=f>=-1&&f<=1,v=$f.distanceTo(V_)<Br*.5;if(p&&v){Un.start.fromBufferAttribute(l,h),Un.end.fromBufferAttribute(c,h),Un.start.applyMatrix4(o),Un.end.applyMatrix4(o);let P=new Y,b=new Y;hs.distanceSqToSegment(Un.start,Un.end,b,P),t.push({point:b,pointOnLine:P,distance:hs.origin.distanceTo(b),object:n,face:null,faceIndex:h,uv:null,uv1:null})}}}var su=class extends zn{constructor(e=new jo,t=new or({color:Math.random()*16777215})){super(e,t),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let e=this.geometry,t=e.attributes.instanceStart,i=e.attributes.instanceEnd,s=new Float32Array(2*t.count);for(let o=0,a=0,l=t.count;o<l;o++,a+=2)k_.fromBufferAttribute(t,o),z_.fromBufferAttribute(i,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+k_.distanceTo(z_);let r=new er(s,2,1);return e.setAttribute("instanceDistanceStart",new Vi(r,1,0)),e.setAttribute("instanceDistanceEnd",new Vi(r,1,1)),this}raycast(e,t){let i=this.material.worldUnits,s=e.camera;if(s===null&&!i&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),i===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=e.params.Line2!==void 0&&e.params.Line2.threshold||0;hs=e.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;Br=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),iu.copy(a.boundingSphere).applyMatrix4(o);let c;if(i)c=Br*.5;else{let d=Math.max(s.near,iu.distanceToPoint(hs.origin));c=G_(s,d,l.resolution)}if(iu.radius+=c,hs.intersectsSphere(iu)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),nu.copy(a.boundingBox).applyMatrix4(o);let u;if(i)u=Br*.5;else{let d=Math.max(s.near,nu.distanceToPoint(hs.origin));u=G_(s,d,l.resolution)}nu.expandByScalar(u),hs.intersectsBox(nu)!==!1&&(i?QE(this,t):eT(this,s,t))}onBeforeRender(e){let t=this.material.uniforms;t&&t.resolution&&(e.getViewport(Yf),this.material.uniforms.resolution.value.set(Yf.z,Yf.w))}};var kr=class extends jo{constructor(){super(),this.isLineGeometry=!0,this.type="LineGeometry"}setPositions(e){let t=e.length-3,i=new Float32Array(2*t);for(let s=0;s<t;s+=3)i[2*s]=e[s],i[2*s+1]=e[s+1],i[2*s+2]=e[s+2],i[2*s+3]=e[s+3],i[2*s+4]=e[s+4],i[2*s+5]=e[s+5];return super.setPositions(i),this}setColors(e){let t=e.length-3,i=new Float32Array(2*t);for(let s=0;s<t;s+=3)i[2*s]=e[s],i[2*s+1]=e[s+1],i[2*s+2]=e[s+2],i[2*s+3]=e[s+3],i[2*s+4]=e[s+4],i[2*s+5]=e[s+5];return super.setColors(i),this}setFromPoints(e){let t=e.length-1,i=new Float32Array(6*t);for(let s=0;s<t;s++)i[6*s]=e[s].x,i[6*s+1]=e[s].y,i[6*s+2]=e[s].z||0,i[6*s+3]=e[s+1].x,i[6*s+4]=e[s+1].y,i[6*s+5]=e[s+1].z||0;return super.setPositions(i),this}fromLine(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}};var ru=class extends su{constructor(e=new kr,t=new or({color:Math.random()*16777215})){super(e,t),this.isLine2=!0,this.type="Line2"}};var tT=new Y(0,1,0),nT=new zo(1,1,1,40),iT=new qa(1,32,20),sT=new js(1,1,1),rT=new Wa(1,1,24);function us(n){return new Vo({color:n,roughness:.55,metalness:.08})}function ou(n,e,t=!0){let i=new zn(n,e);return i.castShadow=t,i.receiveShadow=t,i}var Ls=(n,e)=>ou(nT,n,e),zr=n=>ou(iT,n),au=n=>ou(sT,n),H_=n=>ou(rT,n,!1);function ar(n,e,t,i){let s=At(t,e),r=Ot(s);n.visible=r>1e-9,n.visible&&(n.position.set(...Oe(e,be(s,.5))),n.quaternion.setFromUnitVectors(tT,new Y(...be(s,1/r))),n.scale.set(i,r,i))}function xl(n,e,t,i,s){let r=be(t,i/2);ar(n,At(e,r),Oe(e,r),s)}function lu(n,e,t,[i,s,r]){n.position.set(...e);let o=[...t.x,0,...t.y,0,...t.z,0,0,0,0,1];n.quaternion.setFromRotationMatrix(new Bt().fromArray(o)),n.scale.set(i,s,r)}function Jo(n,e,t=!1){let i=new ru(new kr,new or({color:n,linewidth:e}));return i.frustumCulled=!1,t&&(i.material.depthTest=!1,i.material.transparent=!0,i.renderOrder=2),i}function cu(n,e){n.visible=e.length>1,n.visible&&(n.geometry.dispose(),n.geometry=new kr,n.geometry.setPositions(e.flat()))}function W_(){let n=document.createElement("canvas");[n.width,n.height]=[8,4];let e=n.getContext("2d");for(let i=0;i<4;i++)for(let s=0;s<2;s++)e.fillStyle=(i+s)%2===0?"#111418":"#ffffff",e.fillRect(2*i,2*s,2,2);let t=new Va(n);return t.colorSpace=Zn,t.magFilter=_n,new Vo({map:t,roughness:.6})}function q_(n,e){let{x:t,y:i,z:s,half:r}=Cl(e);return{x:ks(n,t),y:ks(n,i),z:ks(n,s),o:gr(n,e.com),half:r}}function X_(){let n=us("#5c6673");Object.assign(n,{transparent:!0,opacity:.5,depthWrite:!1});let e=au(n);return{mesh:e,put(t,i){let{half:s,...r}=q_(t,i),o=Math.max(...s);lu(e,r.o,r,s.map(a=>2*Math.max(a,.02*o))),e.visible=o>0}}}function Y_(n,e){let{x:t,y:i,z:s,o:r,half:o}=q_(n,e),a=[t,i,s].map((l,c)=>be(l,o[c]));return[-1,1].flatMap(l=>[-1,1].flatMap(c=>[-1,1].map(u=>Oe(r,Oe(Oe(be(a[0],l),be(a[1],c)),be(a[2],u))))))}var oT=["#e03131","#2f9e44","#1c7ed6"];function aT(){let n=new Jn,e=oT.map(i=>{let s=us(i),[r,o]=[Ls(s,!1),H_(s)];return n.add(r,o),{rod:r,head:o}});return{group:n,put:(i,s)=>{[i.x,i.y,i.z].forEach((r,o)=>{let[a,l]=[.78,1].map(c=>Oe(i.o,be(r,c*s)));ar(e[o].rod,i.o,a,.032*s),ar(e[o].head,a,l,.085*s)})}}}function lr(n){let e=n.rows.map((t,i)=>({row:t,index:i}));return n.isMounted?e.filter(({row:t})=>t.mount!==null):e}function $_(n,e,t){let i=lr(e),s=.034*t/Math.sqrt(Math.max(1,i.length/6)),r=x=>s*(1-.45*x/Math.max(i.length,4)),o=us("#c9d1db"),a=us("#5c6673"),l=new Jn;n.scene.add(l);let c=(x,y=l)=>(y.add(x),x),u=e.floating?null:{disc:c(Ls(a)),post:c(Ls(a))},d=e.floating&&X_();d&&c(d.mesh);let h=i.map(({row:x})=>{let y=us("#888888");return{color:y,body:x.isPlace?null:c(x.type==="prismatic"?au(y):Ls(y)),caps:x.isPlace||x.type==="prismatic"?[]:[0,1].map(()=>c(Ls(a))),rods:[0,1].map(()=>c(Ls(o))),corners:[0,1].map(()=>c(zr(o)))}}),m=e.tips.map(()=>({rod:c(Ls(o)),ball:c(zr(a)),stub:c(Ls(o))})),g=c(new Jn),_=[...i,"base","world",...e.tips].map(()=>{let x=aT();return g.add(x.group),x}),f=c(new Jn),p=i.map(({row:x})=>{let y=Jo("#888888",1.6);return y.material.dashed=!0,f.add(y),y.visible=!x.isPlace,y}),v=c(new Jn),P=W_(),b=[...e.rows,...e.tips,...e.floating?[e.floating]:[]].map(()=>c(zr(P),v)),C=c(zr(us("#f08c00")),v);function M(x,y,L){let{row:R,index:I}=i[y],{middle:U,frame:k,link:E,origin:N,axis:z,before:O}=x.rows[I],{body:X,caps:H,rods:Z,corners:te}=h[y],le=r(y),he=e.isMounted?E.o:U.o,Q=e.isMounted?E.o:k.o;if(ar(Z[0],L,he,.52*le),ar(Z[1],he,Q,.52*le),[he,Q].forEach((me,ge)=>{te[ge].position.set(...me),te[ge].scale.setScalar(.52*le)}),!X)return Q;if(R.type==="prismatic"){let me=e.convention==="standard"?O:U;lu(X,e.isMounted?L:N,{...me,z},[1.7*le,1.7*le,3.4*le])}else{let me=e.isMounted?E.o:e.convention==="standard"?N:k.o;xl(X,me,z,2.5*le,le),H.forEach((ge,oe)=>{xl(ge,Oe(me,be(z,(oe===0?1.3:-1.3)*le)),z,.12*le,.5*le)})}return Q}return{paint(x){h.forEach(({color:y},L)=>{y.color.set(x(i[L].row)),p[L].material.color.set(x(i[L].row))}),n.ask()},show({frames:x,axes:y,masses:L}){g.visible=x,f.visible=y,v.visible=L,o.transparent=L,o.opacity=L?.45:1,n.ask()},put(x,y){let L=r(0),R=x.base.o;d?.put(x.base,y.floating),u&&xl(u.disc,At(R,be(x.base.z,1.75*L)),x.base.z,.9*L,1.9*L),u&&xl(u.post,At(R,be(x.base.z,1.1*L)),x.base.z,.6*L,1.25*L);let I=new Map([[null,R]]);i.forEach(({row:X,index:H},Z)=>I.set(H,M(x,Z,I.get(X.on)??R)));let U=r(i.length);m.forEach((X,H)=>{let{on:Z}=y.tips[H],[te,le]=[I.get(Z)??R,x.tips[H].o];ar(X.rod,te,le,.45*U),X.ball.position.set(...le),X.ball.scale.setScalar(.62*U);let he=Z===null?x.base:x.rows[Z].link,Q=Z!==null&&y.convention==="modified"&&Qi(te,le)<.01*t;ar(X.stub,he.o,Q?gr(he,y.rows[Z].com):he.o,.45*U)});let k=.13*t;i.forEach(({index:X},H)=>_[H].put(x.rows[X].link,k)),_[i.length].put(x.base,1.15*k),_[i.length+1].put({x:[1,0,0],y:[0,1,0],z:[0,0,1],o:[0,0,0]},1.5*k),x.tips.forEach((X,H)=>_[i.length+2+H].put(X,k)),i.forEach(({row:X,index:H},Z)=>{if(X.isPlace)return;let{origin:te,axis:le,link:he}=x.rows[H],Q=e.isMounted?he.o:te;cu(p[Z],[-.16,.16].map(me=>Oe(Q,be(le,me*t))))});let[E,N]=[0,[0,0,0]],z=y.rows.map((X,H)=>({...X,frame:x.rows[H].link}));y.tips.forEach(({on:X,body:H},Z)=>z.push({...X===null&&!y.floating?null:H,frame:x.tips[Z]})),y.floating&&z.push({...y.floating,frame:x.base}),b.forEach((X,H)=>{let Z=z[H];if(X.visible=Z.mass>0,!X.visible)return;let te=gr(Z.frame,Z.com);X.position.set(...te),E+=Z.mass,N=Oe(N,be(te,Z.mass))});let O=Math.max(...z.map(X=>X.mass??0));b.forEach((X,H)=>{X.visible&&X.scale.setScalar(.034*t*Math.cbrt(z[H].mass/O))}),C.visible=E>0,E>0&&C.position.set(...be(N,1/E)),C.scale.setScalar(.02*t),n.ask()}}}function jf(n,e,t){let i=[e.base.o,...e.tips.map(r=>r.o)];for(let{index:r}of lr(n)){let{middle:o,link:a}=e.rows[r];i.push(a.o),n.isMounted||i.push(o.o)}n.floating&&i.push(...Y_(e.base,n.floating));for(let{on:r}of n.tips)r!==null&&i.push(gr(e.rows[r].link,n.rows[r].com));let s=.05*t;return i.flatMap(r=>[r,...[0,1,2].flatMap(o=>[-s,s].map(a=>r.map((l,c)=>c===o?l+a:l)))])}var cr={theta:"#e64980",d:"#228be6",a:"#37b24d",alpha:"#f76707"},lT={theta:"\u03B8",d:"d",a:"a",alpha:"\u03B1"},j_="#868e96";function Z_(n,e,t,i,s){let r=Math.max(2,Math.ceil(Math.abs(i)/.06)),o=be(On(At(t,be(e,hi(e,t)))),s);return Array.from({length:r+1},(a,l)=>Oe(n,mr(o,e,i*l/r)))}function cT(n,e){let t=n[n.length-1],i=On(At(t,n[n.length-2])),s=On(pn(i,Math.abs(i[2])<.9?[0,0,1]:[1,0,0]));return[1,-1].map(r=>Oe(t,Oe(be(i,-e),be(s,.4*r*e))))}function hT(n,e,t,i,s){let r=n.rows[t],{before:o,middle:a,frame:l,theta:c,d:u}=e.rows[t],d=n.convention==="standard",h=.115*s,m=t+1,g={paths:[],texts:[]},_=U=>!d&&(U==="a"||U==="alpha")?m-1:m,f=(U,k,E)=>g.texts.push({at:k,name:U,sign:lT[U],index:_(U),text:E}),p=(U,k,E,N)=>{g.paths.push({color:cr[U],path:k,width:3.2});let[z,O]=cT(k,.03*s),X=k[k.length-1];g.paths.push({color:cr[U],path:[z,X,O],width:3.2}),f(U,E,N)},v=(U,k)=>g.paths.push({color:j_,path:[U,k],width:1.4}),P=U=>U[Math.floor(U.length/2)],[b,C]=d?[o,a]:[a,l],[M,x]=d?[a,l]:[o,a],y=d?b.o:C.o,L=d?x.o:M.o,R=U=>Math.abs(U)<1e-9,I=b.z;for(let U of[b.x,C.x])v(y,Oe(y,be(U,1.25*h)));if(R(c))f("theta",Oe(y,be(C.x,1.3*h)),i.angle(0));else{let U=Z_(y,I,b.x,c,h),k=On(At(P(U),y));p("theta",U,Oe(y,be(k,1.2*h)),i.angle(c))}if(Math.abs(u)>1e-9&&p("d",[b.o,C.o],be(Oe(b.o,C.o),.5),i.length(u)),Math.abs(r.a)>1e-9&&p("a",[M.o,x.o],be(Oe(M.o,x.o),.5),i.length(r.a)),!R(r.alpha)){for(let E of[M.z,x.z])v(L,Oe(L,be(E,1.25*h)));let U=Z_(L,M.x,M.z,r.alpha,h),k=On(At(P(U),L));p("alpha",U,Oe(L,be(k,1.2*h)),i.angle(r.alpha))}return g}function uT(n,e,t,i,s,r){let{link:o,axis:a}=e.rows[t],l={paths:[],texts:[]},c=[i.o,o.o];if(Qi(...c)>1e-9){l.paths.push({color:cr.a,path:c,width:3.2});let d=At(o.o,i.o),h=[i.x,i.y,i.z].map(m=>s.number(hi(m,d)));l.texts.push({at:be(Oe(...c),.5),name:"a",sign:"xyz",index:null,text:`${h.join(", ")} m`})}let u=Oe(o.o,be(a,.2*r));return l.paths.push({color:cr.theta,path:[o.o,u],width:3.2}),l.texts.push({at:u,name:"theta",sign:"axis",index:null,text:""}),l}function J_(n,e,t){let i=new Jn;n.scene.add(i);let s=[],r=lr(e);return{put(o,a,l,c){let u=l.map(h=>{if(!e.isMounted)return hT(a,o,h,c,t);let m=r.findIndex(_=>_.index===h),g=m>0?o.rows[r[m-1].index].link:o.base;return uT(a,o,h,g,c,t)}),d=u.flatMap(({paths:h})=>h);for(;s.length<d.length;){let h=Jo(j_,1,!0);i.add(h),s.push(h)}return s.forEach((h,m)=>{h.visible=m<d.length,h.visible&&(cu(h,d[m].path),h.material.color.set(d[m].color),h.material.linewidth=d[m].width)}),n.ask(),u.flatMap(({texts:h})=>h)}}}var dT=24;function K_(n,e,t){let{state:i,size:s}=n,r=zr(us("#f08c00"));r.scale.setScalar(s/45),e.scene.add(r);function o(){r.visible=i.mode==="reach",r.visible&&r.position.set(...i.target.slice(0,3)),e.ask()}let a=({clientX:d,clientY:h})=>{let{left:m,top:g}=e.canvas.getBoundingClientRect();return[d-m,h-g]},[l,c]=[null,null];t.addEventListener("pointerdown",d=>{if(i.mode!=="reach"||d.target!==e.canvas)return;let h=e.onCanvas(i.target.slice(0,3));!h||Qi([...h,0],[...a(d),0])>dT||(l=d.pointerId,e.hold(!0),e.canvas.setPointerCapture(l))},!0),t.addEventListener("pointermove",d=>{if(d.pointerId!==l)return;let h=c!==null;c=a(d),h||requestAnimationFrame(u)});function u(){c!==null&&(e.under(c,i.target.slice(0,3)).forEach((d,h)=>i.target[h]=d),c=null,n.seek(!0))}for(let d of["pointerup","pointercancel"])t.addEventListener(d,h=>{h.pointerId===l&&(u(),l=null,e.hold(!1),n.seek())});e.onDraw(()=>{r.visible&&(t.dataset.handle=e.onCanvas(i.target.slice(0,3))?.map(Math.round).join(" "))}),n.on("reached mode",o),o()}var yl=2;function Q_(n,e){let t=[],i=[];function s(){let r=[],{clientWidth:o,clientHeight:a}=e;t.forEach(({at:l},c)=>{let u=i[c],d=n.onCanvas(l);if(u.hidden=d===null,!d)return;let[h,m]=[u.offsetWidth,u.offsetHeight],g=Math.min(Math.max(d[0]-h/2,2),o-h-2),_=Math.min(Math.max(d[1]-m/2,2),a-m-2);for(let f=0;f<12;f++){let p=r.find(v=>!(g>v.x+v.wide+yl||v.x>g+h+yl)&&_<v.y+v.high+yl&&v.y<_+m+yl);if(!p)break;_=p.y+p.high+yl+.5}r.push({x:g,y:_,wide:h,high:m}),u.style.transform=`translate(${g}px, ${_}px)`})}return n.onDraw(s),{put(r){for(t=r;i.length<r.length;)i.push(e.appendChild(W("span")));i.forEach((o,a)=>{if(o.hidden=a>=r.length,o.hidden)return;let{content:l,kind:c,color:u}=r[a];o.className=`label ${c}`,o.style.setProperty("--color",u),o.replaceChildren(...[l].flat())}),n.ask()}}}var ex={type:"change"},Kf={type:"start"},nx={type:"end"},hu=new Ir,tx=new gi,fT=Math.cos(70*dl.DEG2RAD),wn=new Y,ri=2*Math.PI,Ct={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Jf=1e-6,uu=class extends il{constructor(e,t=null){super(e,t),this.state=Ct.NONE,this.target=new Y,this.cursor=new Y,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:tr.ROTATE,MIDDLE:tr.DOLLY,RIGHT:tr.PAN},this.touches={ONE:nr.ROTATE,TWO:nr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new Y,this._lastQuaternion=new Qn,this._lastTargetPosition=new Y,this._quat=new Qn().setFromUnitVectors(e.up,new Y(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Ho,this._sphericalDelta=new Ho,this._scale=1,this._panOffset=new Y,this._rotateStart=new Ke,this._rotateEnd=new Ke,this._rotateDelta=new Ke,this._panStart=new Ke,this._panEnd=new Ke,this._panDelta=new Ke,this._dollyStart=new Ke,this._dollyEnd=new Ke,this._dollyDelta=new Ke,this._dollyDirection=new Y,this._mouse=new Ke,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=mT.bind(this),this._onPointerDown=pT.bind(this),this._onPointerUp=gT.bind(this),this._onContextMenu=bT.bind(this),this._onMouseWheel=yT.bind(this),this._onKeyDown=vT.bind(this),this._onTouchStart=ST.bind(this),this._onTouchMove=MT.bind(this),this._onMouseDown=_T.bind(this),this._onMouseMove=xT.bind(this),this._interceptControlDown=wT.bind(this),this._interceptControlUp=ET.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ct.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(ex),this.update(),this.state=Ct.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;wn.copy(t).sub(this.target),wn.applyQuaternion(this._quat),this._spherical.setFromVector3(wn),this.autoRotate&&this.state===Ct.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ri:i>Math.PI&&(i-=ri),s<-Math.PI?s+=ri:s>Math.PI&&(s-=ri),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(wn.setFromSpherical(this._spherical),wn.applyQuaternion(this._quatInverse),t.copy(this.target).add(wn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=wn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new Y(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new Y(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=wn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(hu.origin.copy(this.object.position),hu.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(hu.direction))<fT?this.object.lookAt(this.target):(tx.setFromNormalAndCoplanarPoint(this.object.up,this.target),hu.intersectPlane(tx,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Jf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Jf||this._lastTargetPosition.distanceToSquared(this.target)>Jf?(this.dispatchEvent(ex),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?ri/60*this.autoRotateSpeed*e:ri/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){wn.setFromMatrixColumn(t,0),wn.multiplyScalar(-e),this._panOffset.add(wn)}_panUp(e,t){this.screenSpacePanning===!0?wn.setFromMatrixColumn(t,1):(wn.setFromMatrixColumn(t,0),wn.crossVectors(this.object.up,wn)),wn.multiplyScalar(e),this._panOffset.add(wn)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;wn.copy(s).sub(this.target);let r=wn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ri*this._rotateDelta.x/t.clientHeight),this._rotateUp(ri*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(ri*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-ri*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(ri*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-ri*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ri*this._rotateDelta.x/t.clientHeight),this._rotateUp(ri*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Ke,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function pT(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function mT(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function gT(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(nx),this.state=Ct.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function _T(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case tr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Ct.DOLLY;break;case tr.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ct.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ct.ROTATE}break;case tr.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ct.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ct.PAN}break;default:this.state=Ct.NONE}this.state!==Ct.NONE&&this.dispatchEvent(Kf)}function xT(n){switch(this.state){case Ct.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Ct.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Ct.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function yT(n){this.enabled===!1||this.enableZoom===!1||this.state!==Ct.NONE||(n.preventDefault(),this.dispatchEvent(Kf),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(nx))}function vT(n){this.enabled!==!1&&this._handleKeyDown(n)}function ST(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case nr.ROTATE:if(this.enableRotate===!1){this.state=Ct.NONE;break}this._handleTouchStartRotate(n),this.state=Ct.TOUCH_ROTATE;break;case nr.PAN:if(this.enablePan===!1){this.state=Ct.NONE;break}this._handleTouchStartPan(n),this.state=Ct.TOUCH_PAN;break;default:this.state=Ct.NONE}break;case 2:switch(this.touches.TWO){case nr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Ct.TOUCH_DOLLY_PAN;break;case nr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Ct.TOUCH_DOLLY_ROTATE;break;default:this.state=Ct.NONE}break;default:this.state=Ct.NONE}this.state!==Ct.NONE&&this.dispatchEvent(Kf)}function MT(n){switch(this._trackPointer(n),this.state){case Ct.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Ct.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Ct.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Ct.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Ct.NONE}}function bT(n){this.enabled!==!1&&n.preventDefault()}function wT(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function ET(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Qf(n){let e=Math.abs(n[0])<.9?[1,0,0]:[0,1,0],t=On(At(e,be(n,hi(e,n))));return[t,pn(n,t)]}function ix(n,e,t){let i;try{i=new Kh({canvas:n,antialias:!0,alpha:!0})}catch{return null}i.shadowMap.enabled=!0;let s=new Fa,r=new jn(32,1,t/100,t*60);r.up.set(...e);let o=new uu(r,n);o.enableDamping=!1,o.minDistance=t/10,o.maxDistance=t*20;let a=new ja(16777215,9279912,1.6);a.position.set(...e);let[l,c]=Qf(e),u=new Qa(16777215,2.2),d=Oe(Oe(be(e,2.2),be(l,.9)),be(c,-1.1));u.castShadow=!0,u.shadow.mapSize.set(1024,1024),u.shadow.radius=5,u.shadow.bias=-5e-4,u.shadow.normalBias=t/200,Object.assign(u.shadow.camera,{left:-1.6*t,right:1.6*t,top:1.6*t,bottom:-1.6*t,near:.1*t,far:8*t}),s.add(a,u,u.target);let h=new Qn().setFromUnitVectors(new Y(0,0,1),new Y(...e)),m=new zn(new Lr(12*t,12*t),new Ya({opacity:.16}));m.quaternion.copy(h),m.receiveShadow=!0,s.add(m);let g=null,_=!1,f=[],p=()=>{_=!1,i.render(s,r),f.forEach(b=>b())},v=()=>{_||requestAnimationFrame(p),_=!0};o.addEventListener("change",v);let P=()=>{let{clientWidth:b,clientHeight:C}=n;b===0||C===0||(i.setPixelRatio(Math.min(devicePixelRatio,2)),i.setSize(b,C,!1),r.aspect=b/C,r.updateProjectionMatrix(),v())};return new ResizeObserver(P).observe(n),{scene:s,camera:r,canvas:n,ask:v,onDraw:b=>f.push(b),ground(b,C,M,x=!0){m.visible=x;let y=Oe(b,be(e,C-hi(b,e)));m.position.set(...y),u.target.position.set(...b),u.position.set(...Oe(b,be(On(d),4*t))),g&&s.remove(g);let L=10**Math.floor(Math.log10(t/2)),R=[1,2,5,10].map(U=>U*L).find(U=>U>=t/8),I=2*Math.ceil(2*t/R);return g=new nl(I*R,I,new ht(M[0]),new ht(M[1])),g.quaternion.setFromUnitVectors(new Y(0,1,0),new Y(...e)),g.position.set(...Oe(y,be(e,-t/500))),s.add(g),v(),R},look(b,C){P();let x=[0,1,2].map(U=>C.map(k=>k[U])).map(U=>(Math.min(...U)+Math.max(...U))/2),y=Math.max(...C.map(U=>Ot(At(U,x))),t/8),L=r.fov*Math.PI/360,R=Math.min(L,Math.atan(Math.tan(L)*r.aspect)),I=1.12*y/Math.sin(R);r.position.set(...Oe(x,be(On(b),I))),o.target.set(...x),o.update(),v()},follow(b){for(let{position:C}of[r,u,u.target])C.set(...Oe(C.toArray(),b));o.target.set(...Oe(o.target.toArray(),b)),o.update(),v()},turn(b,C){let M=o.target.toArray(),x=At(r.position.toArray(),M),y=On(pn(e,x)),L=mr(mr(x,e,b),y,-C);Ot(pn(On(L),e))<.05||(r.position.set(...Oe(M,L)),o.update(),v())},zoom(b){let C=o.target.toArray(),M=At(r.position.toArray(),C);r.position.set(...Oe(C,be(M,b))),o.update(),v()},under([b,C],M){let{clientWidth:x,clientHeight:y}=n,{z:L}=new Y(...M).project(r);return new Y(2*b/x-1,1-2*C/y,L).unproject(r).toArray()},hold(b){o.enabled=!b},onCanvas(b){let C=new Y(...b).project(r);if(C.z>1)return null;let{clientWidth:M,clientHeight:x}=n;return[(C.x+1)/2*M,(1-C.y)/2*x]}}}var TT=[.1,.25,.5,1,2],sx={play:"M7 4.5v15l12.5-7.5z",pause:"M6.5 4.5h4v15h-4zM13.5 4.5h4v15h-4z"};function AT(n){let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true");let t=document.createElementNS("http://www.w3.org/2000/svg","path");return t.setAttribute("d",n),e.append(t),e}function rx(n){let{state:e}=n,t=W("button",{type:"button",class:"play","data-key":"play"}),i=W("input",{type:"range",min:0,step:"any","data-key":"time","aria-label":"Time"}),s=W("output",{class:"time","data-key":"seconds"}),r=W("select",{"aria-label":"Speed","data-key":"speed"},TT.map(h=>W("option",{value:h,selected:h===1},`${h}\xD7`))),o=W("input",{type:"checkbox","data-key":"repeat"}),a=null;function l(h){if(!e.isPlaying){a=null;return}if(a!==null){let{duration:m}=n.trajectory,g=e.t+(h-a)/1e3*e.speed;g>=m&&o.checked&&m>0&&(g%=m),g>=m&&n.play(!1),n.setTime(g)}a=h,requestAnimationFrame(l)}function c(){t.replaceChildren(AT(e.isPlaying?sx.pause:sx.play)),t.setAttribute("aria-label",e.isPlaying?"Pause":"Play"),e.isPlaying&&a===null&&requestAnimationFrame(l)}function u(){let{duration:h}=n.trajectory??{duration:0};i.max=h,i.value=e.t;let m=`${e.t.toFixed(2)} / ${h.toFixed(2)} s`;i.setAttribute("aria-valuetext",m),s.textContent=m,d.hidden=n.trajectory===null}t.addEventListener("click",()=>n.play(!e.isPlaying)),i.addEventListener("input",()=>{n.play(!1),n.setTime(Number(i.value))}),r.addEventListener("change",()=>e.speed=Number(r.value));let d=W("div",{class:"transport",role:"group","aria-label":"Time"},t,i,s,r,W("label",{class:"check"},o,"repeat"));return n.on("play",c),n.on("time trajectory",u),c(),u(),d}function RT(n){return Ot(n.gravity)>1e-9?On(be(n.gravity,-1)):[0,0,1]}function CT(n,e){if(n.floating)return null;let{rows:t}=Ii(n,new Array(n.joints).fill(0),null),i=n.rows.flatMap((o,a)=>o.type==="revolute"&&o.joint!==null?[t[a].axis]:[]);if(i.length===0)return null;let[s]=i;return i.every(o=>Ot(pn(s,o))<1e-6)&&Math.abs(hi(s,e))<1e-6?s:null}function ox(n){let{table:e,state:t,size:i}=n,s=W("canvas",{tabIndex:0,role:"img"}),r=W("div",{class:"labels","aria-hidden":"true"}),o=W("output",{class:"readout"}),a=W("span",{class:"scale"}),l=W("div",{class:"views",role:"group","aria-label":"View"}),c=W("div",{class:"shown",role:"group","aria-label":"What is shown"}),u=W("div",{class:"view"},s,r,l,o,a),d=W("section",{class:"panel stage","aria-label":"The arm"},u,c,rx(n));s.setAttribute("aria-label",`${e.name} in 3D; drag to turn, arrow keys too, plus and minus to zoom`);function h(){let f=RT(e),p=ix(s,f,i);if(!p){u.classList.add("missing"),u.append(W("p",{},"This browser draws no WebGL: the arm is not shown. All numbers are."));return}let v=$_(p,e,i),P=J_(p,e,i),b=Q_(p,r);K_(n,p,u);let C=lr(e),M=Jo("#f08c00",2.4);M.visible=!1,p.scene.add(M);let x=CT(e,f),[y,L]=Qf(f),R=x??be(L,-1),I=pn(f,R),k={"3D":x?Oe(Oe(R,be(I,.22)),be(f,.16)):Oe(Oe(be(y,.75),be(L,-.9)),be(f,.55)),front:Oe(R,be(f,1e-4)),side:Oe(I,be(f,1e-4)),top:Oe(f,be(R,.001))},E="3D";function N(oe,de,Ne){let Ye=Ii(n.table,de,oe),Be=H()?At(Ne,Ye.base.o):[0,0,0];return jf(n.table,Ye,i).map(st=>Oe(st,Be))}function z(oe){E=oe;let de=n.trajectory??{q:[],base:[]},Ne=Math.max(1,Math.floor(de.q.length/12)),Ye=n.frames().base.o,Be=de.q.flatMap(($e,pt)=>pt%Ne===0||pt===de.q.length-1?N(de.base[pt],$e,Ye):[]).concat(N(n.start(),t.q,Ye)).filter($e=>Qi($e,Ye)<1.6*i);X=Ye;let st=Ii(n.table,t.q,n.start()),at=e.floating?jf(n.table,st,i):Be;O=Math.min(...at.map($e=>hi($e,f)),hi(st.base.o,f)-.09*i),te(),p.look(k[oe],Be.length>0?Be:[Ye])}let O=0,X=[0,0,0],H=()=>e.floating!==null&&t.mode==="free"&&t.show.isFollowed;function Z(oe){H()&&p.follow(At(oe,X)),X=oe}function te(){let{base:oe}=Ii(n.table,t.q,n.start()),de=e.floating!==null&&t.mode==="free",Ne=p.ground(oe.o,O,[Tr("--grid-strong"),Tr("--grid")],!de);a.textContent=`grid ${Ne>=1?Ne:Number(Ne.toPrecision(3))} m`}for(let oe of Object.keys(k))l.append(W("button",{type:"button",class:"chip","data-key":`view-${oe}`,onclick:()=>z(oe)},oe));s.addEventListener("keydown",({key:oe})=>{let de={ArrowLeft:[-.1,0],ArrowRight:[.1,0],ArrowUp:[0,.1],ArrowDown:[0,-.1]};de[oe]&&p.turn(...de[oe]),(oe==="+"||oe==="-")&&p.zoom(oe==="+"?.9:1/.9)});function le(){let{parameters:oe}=t.show;if(oe==="none")return[];let de=C.filter(({row:Ne})=>!Ne.isPlace).map(({index:Ne})=>Ne);return oe==="all"?de:de.filter(Ne=>Ne===t.selected)}function he(){let oe=n.frames();Z(oe.base.o),v.put(oe,n.table);let de=P.put(oe,n.table,le(),n.units),Ne=({o:pt},Mt)=>({at:pt,content:Mt,kind:"frame",color:"var(--ink)"}),Ye=t.show.frames?[Ne(oe.base,"0"),...C.map(({row:pt,index:Mt},jt)=>Ne(oe.rows[Mt].link,pt.isPlace?"tip":String(jt+1))),...(e.tips.length>1?e.tips:[]).map((pt,Mt)=>Ne(oe.tips[Mt],pt.name))]:[],Be=de.map(({at:pt,name:Mt,sign:jt,index:Pt,text:rn})=>({at:pt,content:[...fn(jt,Pt),rn?` = ${rn}`:""],kind:"parameter",color:cr[Mt]}));b.put([...Ye,...Be]);let[st,at,$e]=oe.tips[t.tip].o.map(pt=>(Math.abs(pt)<5e-7?0:pt).toFixed(4));o.textContent=`${n.tip().name}  x ${st}  y ${at}  z ${$e} m`,me()}function Q(){let{trajectory:oe}=n,de=oe?.tip??[];M.visible=de.length>1,M.visible&&(M.geometry.dispose(),M.geometry=new M.geometry.constructor,M.geometry.setPositions(de.flat()),me())}function me(){let{trajectory:oe}=n;if(!oe||oe.t.length<2){M.visible=!1;return}let de=Math.floor(t.t/oe.duration*(oe.t.length-1)+1e-9);M.visible=t.show.trace&&de>0,M.geometry.instanceCount=de,p.ask()}function ge(){let oe=de=>de.joint??de.follows?.joint;v.paint(de=>Tr(oe(de)===void 0?"--muted":`--joint-${oe(de)%8}`)),M.material.color.set(Tr("--trace")),te()}n.on("time fields units selection tip",he),n.on("trajectory",Q),n.on("show",()=>{v.show(t.show),he()}),n.on("theme",ge),n.on("mode",()=>z(E)),v.show(t.show),z("3D"),ge(),he(),Q(),requestAnimationFrame(()=>z("3D"))}let m=W("select",{"data-key":"parameters"},Object.entries({selected:"selected row",all:"all rows",none:"none"}).map(([f,p])=>W("option",{value:f},p)));m.addEventListener("change",()=>n.setShown({parameters:m.value}));let g=e.isMounted?"placement":"D-H parameters";if(c.append(W("label",{class:"choice"},W("span",{},g),m)),e.tips.length>1){let f=W("select",{"data-key":"tip"},e.tips.map(({name:p},v)=>W("option",{value:v},p)));f.addEventListener("change",()=>n.setTip(Number(f.value))),c.append(W("label",{class:"choice"},W("span",{},"frame"),f))}let _={frames:"frames",axes:"axes",masses:"masses",trace:"trace"};e.floating&&(_.isFollowed="follow the fall");for(let[f,p]of Object.entries(_)){let v=W("input",{type:"checkbox",checked:t.show[f],"data-key":`show-${f}`});v.addEventListener("change",()=>n.setShown({[f]:v.checked})),c.append(W("label",{class:"check"},v,p))}return{section:d,start:h}}var PT={theta:"\u03B8",d:"d",a:"a",alpha:"\u03B1"},IT={standard:["theta","d","a","alpha"],modified:["alpha","a","d","theta"]},hr=(n,e=4)=>n.map(t=>mt(t,e)).join(", ");function ax(n){let{table:e,state:t}=n,i=lr(e),s=e.isMounted?["xyz","rpy","axis"]:IT[e.convention],r=e.rows.some(y=>y.limits),o=e.rows.some(y=>y.gearRatio!==0&&y.motorInertia!==0),a=e.rows.some(y=>y.viscous||y.coulomb.some(Boolean)||y.stribeck||y.spring),l=W("input",{type:"checkbox","data-key":"bodies"}),c=W("thead"),u=W("tbody"),d=W("caption");function h(){let{angleUnit:y}=n.units,L=I=>e.convention==="modified"&&(I==="a"||I==="alpha"),R=s.map(I=>{if(e.isMounted){let N={xyz:"m",rpy:y,axis:""}[I];return W("th",{scope:"col"},I," ",W("span",{class:"unit"},N))}let U=W("span",{class:"swatch"});U.style.background=cr[I];let k=I==="a"||I==="d"?"m":y,E=fn(PT[I],L(I)?"i\u22121":"i");return W("th",{scope:"col"},U,E," ",W("span",{class:"unit"},k))});r&&R.push(W("th",{scope:"col"},"limits")),R.push(W("th",{scope:"col"},"mass ",W("span",{class:"unit"},"kg"))),l.checked&&(R.push(W("th",{scope:"col"},"centre of mass ",W("span",{class:"unit"},"m"))),R.push(W("th",{scope:"col"},"inertia xx, yy, zz, xy, yz, xz ",W("span",{class:"unit"},"kg m\xB2"))),o&&R.push(W("th",{scope:"col"},"motor")),a&&R.push(W("th",{scope:"col"},"friction, spring"))),c.replaceChildren(W("tr",{},W("th",{scope:"col"},"joint"),R))}function m(y){if(y.joint!==null)return fn("q",y.joint+1);if(!y.follows)return null;let{joint:L,factor:R,offset:I}=y.follows,U=R===1?"":R===-1?"-":`${mt(R)} `,k=I===0?"":` ${I<0?"-":"+"} ${mt(Math.abs(I))}`;return[U,...fn("q",L+1),k]}function g(y,L){let{cell:R}=n.units;if(e.isMounted){let{places:O,axis:X}=y.mount,H=bp(O),[Z,te]=X,le=[Math.sin(te)*Math.cos(Z),Math.sin(te)*Math.sin(Z),Math.cos(te)],he={xyz:hr(H.xyz),rpy:H.rpy.map(R).join(", "),axis:hr(le.map(Q=>Math.abs(Q)<1e-12?0:Q))};return W("td",{},L==="axis"&&y.isPlace?"":he[L])}let I=L==="theta"||L==="alpha",U=I?R(y[L]):mt(y[L],6),k=y.text[L],E=L===(y.type==="prismatic"?"d":"theta"),N=E?m(y):null,z=k?[W("i",{},k),W("span",{class:"unit"},` = ${U}`)]:[U];if(N)return W("td",{class:"variable"},N,y[L]===0&&!k?null:[" + ",z]);if(E&&y.locked!==null&&!y.isPlace){let O=y[L]+y.locked;return W("td",{},I?R(O):mt(O,6)," ",W("span",{class:"kind"},"locked"))}return W("td",{},z)}function _(y){let{viscous:L,coulomb:R,stribeck:I,spring:U}=y,k=R[0]===R[1];return[L?`viscous ${mt(L)}`:null,R.some(Boolean)?`Coulomb ${k?mt(R[0]):`+${mt(R[0])} / -${mt(R[1])}`}`:null,I?`static ${mt(I.friction)} below ${mt(I.velocity)}`:null,U?`spring ${mt(U.stiffness)} at ${mt(U.rest)}`:null].filter(Boolean).join(", ")}let f=({xyz:y,rpy:L})=>`xyz ${hr(y)} m, rpy ${L.map(n.units.cell).join(", ")} ${n.units.angleUnit}`,p=y=>y===null?"the base":e.rows[y].name;function v(y,L){return y.follows?e.isMounted?["follows ",m(L)]:"follows":y.locked===null?y.type:e.isMounted?`locked at ${mt(L.locked*n.units.factor(y.type))} ${n.units.position(y.type)}`:"locked"}function P({row:y,index:L}){let R=n.table.rows[L],{factor:I,position:U}=n.units,k=y.joint??y.follows?.joint,E=W("th",{scope:"row"});if(y.isPlace)E.append("tip");else{let z=W("button",{type:"button",class:"name",onclick:()=>n.select(L)});z.append(W("span",{class:"dot"}),y.name||"fixed"," "),z.append(W("span",{class:"kind"},v(y,R))),(y.on??-1)!==L-1&&z.append(W("span",{class:"kind"},` on ${p(y.on)}`));let O=e.isMounted?[]:R.step.map(X=>`, at ${f(X)}`);z.append(W("span",{class:"kind"},...O)),E.append(z)}E.style.setProperty("--color",k===void 0?"var(--muted)":`var(--joint-${k%8})`);let N=s.map(z=>g(R,z));if(r){let z=I(y.type),O=R.limits?.map(X=>mt(X*z));N.push(W("td",{},O?`${O[0]} \u2026 ${O[1]} ${U(y.type)}`:""))}if(N.push(W("td",{},R.text.mass?[W("i",{},R.text.mass),` = ${mt(R.mass)}`]:mt(R.mass))),l.checked){N.push(W("td",{},hr(R.com)),W("td",{},hr(R.inertia)));let{motorInertia:z,gearRatio:O}=R;o&&N.push(W("td",{},z?`${mt(z)} kg m\xB2 \xD7 ${mt(O)}\xB2`:"")),a&&N.push(W("td",{},_(R)))}return W("tr",{"data-row":L},E,N)}function b(y,L,R){let I=[W("td",{colSpan:s.length+(r?1:0)},f(L)),W("td",{},R)];return l.checked&&I.push(W("td",{colSpan:4},L.com?hr(L.com):"")),W("tr",{class:"placed"},W("th",{scope:"row"},y),I)}function C({mass:y,com:L,inertia:R}){let I=[W("td",{colSpan:s.length+(r?1:0)},"moves freely"),W("td",{},mt(y))];return l.checked&&I.push(W("td",{},hr(L)),W("td",{},hr(R))),W("tr",{class:"placed"},W("th",{scope:"row"},"base"),I)}function M(){let{base:y,floating:L,tool:R}=n.table;h();let I=i.map(P);y&&I.unshift(b("base",y,"")),L&&I.unshift(C(L)),R&&I.push(b("tool",R,mt(R.mass)));for(let{name:U,on:k,places:E,body:N}of n.table.tips.filter(z=>z.isFrame&&z.places.length===1))I.push(b(`${U} on ${p(k)}`,{...E[0],com:N?.com},N?mt(N.mass):""));u.replaceChildren(...I),d.textContent=e.isMounted?"Joints as the file places them":`Denavit-Hartenberg table, ${e.convention} convention`,x()}function x(){for(let y of u.children)y.classList.toggle("selected",Number(y.dataset.row)===t.selected)}return l.addEventListener("change",M),n.on("fields units",M),n.on("selection",x),M(),W("section",{class:"panel table","aria-label":"Table"},Pi("Table of the arm",W("table",{class:"cells"},d,c,u)),W("label",{class:"check"},l,"bodies, motors, friction"))}var ep=["auto","light","dark"];function LT({floating:n,convention:e,isMounted:t,gravity:i},s){let r=s.map(({type:u})=>u==="revolute"?"R":"P").join(""),o=i.map(u=>mt(u)).join(", "),a=t?"joints of a URDF file":`${e} D-H table`,l=n?["a base that moves"]:[],c=s.length===0?[]:[`${s.length} ${s.length===1?"joint":"joints"} (${r})`,a];return[...l,...c,`gravity (${o}) m/s\xB2`].join(", ")}function DT(n){let e=W("button",{type:"button",class:"quiet","data-key":"theme"}),t=0,i=()=>{document.documentElement.dataset.theme=ep[t],e.textContent=`Colors: ${ep[t]}`};e.addEventListener("click",()=>{t=(t+1)%ep.length,i(),n.tell("theme")}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>n.tell("theme")),i();let s=W("button",{type:"button",class:"quiet","data-key":"units"}),r=()=>s.textContent=`Angles: ${n.units.inDegrees?"degrees":"radians"}`;return s.addEventListener("click",()=>n.setUnits(!n.units.inDegrees)),n.on("units",r),r(),W("header",{},W("div",{},W("h1",{},n.table.name),W("p",{class:"said"},LT(n.table,n.joints))),W("div",{class:"switches"},s,e))}var Vr=gm(globalThis.robotTable,globalThis.robotEquations,globalThis.robotStart),lx=ox(Vr),cx=Hg(Vr);document.getElementById("page").append(DT(Vr),W("main",{},W("div",{class:"column fixed"},lx.section,ax(Vr)),W("div",{class:"column"},Fp(Vr),Np(Vr),cx.section)),W("footer",{},"M, V, G, \u03C4 and the motion are computed in this page by functions that robot-dynamics has proven equal to the textbook Lagrangian. SI units."));lx.start();cx.build();globalThis.robotPage=Vr;document.documentElement.dataset.ready="true";
